// Space: vectors, poses, shapes, depths and contacts.
using System;

namespace Gjk {
    public unsafe partial struct Vec3 {
        public Vec3(int x, int y, int z) { X = x; Y = y; Z = z; }
        public override string ToString() { return "(" + X + ", " + Y + ", " + Z + ")"; }
    }

    public unsafe partial struct Quat {
        public static readonly Quat Identity = new Quat { W = Constants.Q30One };

        /// <summary>By an angle, Q16.16 radians, about an axis of any length.</summary>
        public static Status AxisAngle(Vec3 axis, int angle, out Quat result) {
            fixed (Quat* to = &result) return Native.gjk_quat_from_axis_angle(&axis, angle, to);
        }

        public static Status Normalize(Quat q, out Quat result) {
            fixed (Quat* to = &result) return Native.gjk_quat_normalize(&q, to);
        }

        /// <summary>First b, then a.</summary>
        public static Status Compose(Quat a, Quat b, out Quat result) {
            fixed (Quat* to = &result) return Native.gjk_quat_compose(&a, &b, to);
        }
    }

    public unsafe partial struct Pose {
        public static readonly Pose Identity = new Pose(new Vec3(0, 0, 0));
        public Pose(Vec3 position) { Position = position; Rotation = Quat.Identity; }
        public Pose(Vec3 position, Quat rotation) { Position = position; Rotation = rotation; }
    }

    public sealed unsafe partial class Shape {
        public static Shape Sphere(int radius) {
            Shape made = new Shape(none);
            return made.Made(Native.gjk_shape_point(radius, made.Data));
        }

        /// <summary>Along z.</summary>
        public static Shape Capsule(int radius, int half) {
            Shape made = new Shape(none);
            return made.Made(Native.gjk_shape_segment(half, radius, made.Data));
        }

        public static Shape Box(Vec3 half, int radius = 0) {
            Shape made = new Shape(none);
            return made.Made(Native.gjk_shape_box(half.X, half.Y, half.Z, radius, made.Data));
        }

        public static Shape Cylinder(int baseRadius, int half, int radius = 0) {
            Shape made = new Shape(none);
            return made.Made(Native.gjk_shape_cylinder(baseRadius, half, radius, made.Data));
        }

        public static Shape Cone(int baseRadius, int half, int radius = 0) {
            Shape made = new Shape(none);
            return made.Made(Native.gjk_shape_cone(baseRadius, half, radius, made.Data));
        }

        public static Shape Ellipsoid(Vec3 radii, int radius = 0) {
            Shape made = new Shape(none);
            return made.Made(Native.gjk_shape_ellipsoid(radii.X, radii.Y, radii.Z, radius, made.Data));
        }

        public static Shape Triangle(Vec3[] vertices, int radius = 0) {
            if (CountOf(vertices) != 3) throw new GjkException(Status.ErrorRange);
            Shape made = new Shape(vertices);
            return made.Made(Native.gjk_shape_triangle(made.vertices, radius, made.Data));
        }

        /// <summary>The convex hull of vertices in any order.</summary>
        public static Shape Hull(Vec3[] vertices, int radius = 0) {
            ushort count = CountOf(vertices);
            Shape made = new Shape(vertices);
            return made.Made(Native.gjk_shape_hull(made.vertices, count, null, radius, made.Data));
        }
    }

    /// <summary>Memory for the depth of hulls and curved shapes. Not for two threads at a time.</summary>
    public sealed unsafe class Workspace : Block {
        readonly WorkspaceData* data;

        /// <param name="vertices">Of both shapes together.</param>
        public Workspace(int vertices = 1000) {
            long cells = (long)(ulong)Native.gjk_workspace_bytes(checked((ushort)vertices));
            data = (WorkspaceData*)Allocate(sizeof(WorkspaceData) + cells);
            data->Cells = (EpaCell*)(data + 1);
            data->Count = (uint)(cells / sizeof(EpaCell));
        }

        internal WorkspaceData* Data { get { NotDisposed(); return data; } }
    }

    public static unsafe partial class Query {
        public static Status Penetration(Collider a, Collider b, Workspace workspace, out PenetrationResult result) {
            fixed (PenetrationResult* to = &result) return Native.gjk_penetration(a.Data, b.Data, null, workspace.Data, to);
        }

        public static Status Penetration(Collider a, Collider b, ref Cache cache, Workspace workspace, out PenetrationResult result) {
            fixed (Cache* kept = &cache) fixed (PenetrationResult* to = &result) {
                return Native.gjk_penetration(a.Data, b.Data, kept, workspace.Data, to);
            }
        }

        public static Status SignedDistance(Collider a, Collider b, Workspace workspace, out DistanceResult result) {
            fixed (DistanceResult* to = &result) return Native.gjk_signed_distance(a.Data, b.Data, null, workspace.Data, to);
        }

        /// <param name="most">Contacts, 1 to 8.</param>
        public static Status Contacts(Collider a, Collider b, int margin, int most, Workspace workspace, out Manifold result) {
            fixed (Manifold* to = &result) {
                return Native.gjk_contacts(a.Data, b.Data, margin, (uint)most, null, workspace.Data, to);
            }
        }
    }

    public sealed unsafe partial class Scene {
        static long Cells(SceneConfig config) {
            return sizeof(WorkspaceData) + (long)sizeof(EpaCell) * config.WorkspaceCells;
        }

        SceneBindings Bind(SceneConfig config, byte* memory) {
            SceneBindings bindings;
            WorkspaceData* workspace = (WorkspaceData*)memory;
            workspace->Cells = (EpaCell*)(workspace + 1);
            workspace->Count = config.WorkspaceCells;
            Native.gjk_scene_bind_all(&bindings);
            bindings.Workspace = workspace;
            bindings.Manifolds = manifolds;
            return bindings;
        }
    }
}
