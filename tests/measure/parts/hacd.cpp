// HACD, as Debian builds it beside Bullet.
#include <cstdlib>
#include <vector>

#include "hacdHACD.h"
#include "peer.h"

void parts_by_hacd(const int32_t (*point)[3], size_t points, const uint32_t (*triangle)[3], size_t triangles,
                   const peer_settings *settings, peer_parts *out) {
  std::vector<HACD::Vec3<HACD::Real>> at;
  std::vector<HACD::Vec3<long>> face;
  for (size_t i = 0; i < points; i++) {
    at.emplace_back(point[i][0], point[i][1], point[i][2]);
  }
  for (size_t t = 0; t < triangles; t++) {
    face.emplace_back(triangle[t][0], triangle[t][1], triangle[t][2]);
  }
  HACD::HACD hacd;
  hacd.SetPoints(at.data());
  hacd.SetNPoints(points);
  hacd.SetTriangles(face.data());
  hacd.SetNTriangles(triangles);
  hacd.SetCompacityWeight(0.0001);
  hacd.SetVolumeWeight(0.0);
  hacd.SetConnectDist(30);
  hacd.SetNClusters(1);
  hacd.SetNVerticesPerCH(1000);
  hacd.SetConcavity(settings->concavity);
  hacd.SetAddExtraDistPoints(settings->more != 0);
  hacd.SetAddNeighboursDistPoints(settings->more != 0);
  hacd.SetAddFacesPoints(settings->more != 0);
  out->parts = 0;
  out->point = nullptr;
  out->end = nullptr;
  if (!hacd.Compute(true)) {
    return;
  }
  size_t count = 0;
  out->parts = hacd.GetNClusters();
  out->end = static_cast<size_t *>(std::calloc(out->parts + 1, sizeof out->end[0]));
  std::vector<HACD::Vec3<HACD::Real>> all;
  for (size_t c = 0; c < out->parts; c++) {
    std::vector<HACD::Vec3<HACD::Real>> corner(hacd.GetNPointsCH(c));
    std::vector<HACD::Vec3<long>> facet(hacd.GetNTrianglesCH(c));
    hacd.GetCH(c, corner.data(), facet.data());
    all.insert(all.end(), corner.begin(), corner.end());
    out->end[c] = count += corner.size();
  }
  out->point = static_cast<double(*)[3]>(std::calloc(count + 1, sizeof out->point[0]));
  for (size_t i = 0; i < count; i++) {
    out->point[i][0] = all[i].X();
    out->point[i][1] = all[i].Y();
    out->point[i][2] = all[i].Z();
  }
}
