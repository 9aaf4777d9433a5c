// The golden set of queries of tests/check/target/golden.c through the C# classes.
using Gjk;

public sealed class Golden {
    const int Vertices = 16;
    static readonly int[] kinds = { 0, 1, 2, 3, 3, 4, 4, 4, 5, 6, 7 };  // boxes and hulls are chosen twice as often

    readonly Dice dice = new Dice(2026);
    readonly Workspace workspace = new Workspace(20);
    ulong hash = 0xCBF29CE484222325;

    void Mix(int word) {
        for (int i = 0; i < 32; i += 8) hash = (hash ^ ((uint)word >> i & 0xFF)) * 0x100000001B3;
    }

    void Mix(Vec3 v) { Mix(v.X); Mix(v.Y); Mix(v.Z); }
    void Mix(Unit3 v) { Mix(v.X); Mix(v.Y); Mix(v.Z); }
    void Mix(bool b) { Mix(b ? 1 : 0); }

    Vec3 Vector(int size) {
        int x = dice.Range(-size, size), y = dice.Range(-size, size);
        return new Vec3(x, y, dice.Range(-size, size));
    }

    Collider Body(int size, int reach) {
        int kind = kinds[dice.Below(11)];
        int x = dice.Range(1, size), y = dice.Range(1, size), z = dice.Range(1, size);
        Vec3[] v = new Vec3[kind == 2 ? 3 : 4 + (int)dice.Below(Vertices - 3)];
        int grid = dice.Below(4) == 0 ? size / 2 + 1 : 1;  // coarse: ties, and parallel faces
        for (int i = 0; i < v.Length; i++) {
            Vec3 any = Vector(size);
            v[i] = new Vec3(any.X / grid * grid, any.Y / grid * grid, any.Z / grid * grid);
        }
        int radius = dice.Below(4) == 0 ? dice.Range(0, size / 2) : 0;
        Pose pose = Pose.Identity;
        if (dice.Below(4) != 0) {
            Quat q;
            q.X = dice.Range(-1000, 1000);
            q.Y = dice.Range(-1000, 1000);
            q.Z = dice.Range(-1000, 1000);
            q.W = dice.Range(-1000, 1001);
            Mix((int)Quat.Normalize(q, out pose.Rotation));
        }
        pose.Position = Vector(reach);
        bool baked = dice.Below(2) == 0;
        Mix(0);  // of gjk_collider_init and gjk_collider_pose
        Mix(0);
        using (Shape shape = Of(kind, new Vec3(x, y, z), v, radius)) return new Collider(shape, pose, baked);
    }

    static Shape Of(int kind, Vec3 size, Vec3[] v, int radius) {
        switch (kind) {
            case 0: return Shape.Sphere(radius);
            case 1: return Shape.Capsule(radius, size.Z);
            case 2: return Shape.Triangle(v, radius);
            case 3: return Shape.Box(size, radius);
            case 4: return Shape.Hull(v, radius);
            case 5: return Shape.Cylinder(size.X, size.Z, radius);
            case 6: return Shape.Cone(size.X, size.Z, radius);
            default: return Shape.Ellipsoid(size, radius);
        }
    }

    DistanceResult Mix(Status status, DistanceResult r) {
        Mix((int)status);
        Mix(r.Intersecting);
        Mix(r.Saturated);
        Mix(r.Distance);
        if (!r.Intersecting) {
            Mix(r.PointA);
            Mix(r.PointB);
            Mix(r.Normal);
        }
        return r;
    }

    void Mix(Status status, Decision decision) {
        Mix((int)status);
        Mix(decision.Yes);
    }

    void Until(Collider a, Collider b, byte iterations, int error) {
        DistanceResult r;
        Mix((int)Query.DistanceUntil(a, b, new Effort { Iterations = iterations, Error = error }, out r));
        Mix(r.Intersecting);
        Mix(r.Distance);
        Mix(r.Lower);
        Mix(r.Upper);
        if (!r.Intersecting) Mix(r.PointA);
    }

    void Until(Collider a, Collider b, int most, byte iterations) {
        WithinResult r;
        Mix((int)Query.WithinUntil(a, b, most, iterations, out r));
        Mix((int)r.Answer);
    }

    void Mix(Status status, PenetrationResult r) {
        Mix((int)status);
        Mix(r.Intersecting);
        if (r.Intersecting) {
            Mix(r.Depth);
            Mix(r.Lower);
            Mix(r.Upper);
            Mix(r.PointA);
            Mix(r.PointB);
            Mix(r.Normal);
        }
    }

    void Contacts(Collider a, Collider b, int margin) {
        Manifold m;
        Mix((int)Query.Contacts(a, b, margin, 4, workspace, out m));
        Mix(m.Count);
        for (int i = 0; i < m.Count; i++) {
            Contact c = m.Contact(i);
            Mix(c.PointA);
            Mix(c.PointB);
            Mix(c.Distance);
            Mix(c.Id);
        }
    }

    static int Along(int normal, int by) { return (int)((long)normal * by / Constants.Q30One); }

    void Pair() {
        int size = 1 << (3 + (int)dice.Below(23));
        bool far = dice.Below(8) == 0;
        int reach = far ? int.MaxValue : 2 * size;
        using (Collider a = Body(size, reach))
        using (Collider b = Body(size, reach)) {
            Cache cache = default(Cache);
            DistanceResult r;
            Decision d;
            PenetrationResult p;
            Mix(Query.Distance(a, b, out r), r);
            Mix(Query.Intersect(a, b, out d), d);
            Mix(Query.Within(a, b, r.Distance, out d), d);
            Mix(Query.Distance(a, b, ref cache, out r), r);
            Mix(Query.Penetration(a, b, ref cache, workspace, out p), p);
            Contacts(a, b, 0);
            if (r.Intersecting || far) return;
            int by = r.Distance + dice.Range(-2, 2);
            Vec3 at = b.Position;
            Unit3 n = r.Normal;
            Mix((int)b.SetPosition(new Vec3(at.X - Along(n.X, by), at.Y - Along(n.Y, by), at.Z - Along(n.Z, by))));
            Mix(Query.Distance(a, b, ref cache, out r), r);
            Mix(Query.Intersect(a, b, ref cache, out d), d);
            Mix(Query.Within(a, b, 1, out d), d);
            Until(a, b, 1 + size / 32, (byte)1);
            Until(a, b, r.Distance, (byte)2);
            Until(a, b, (byte)2, 0);
            Until(a, b, (byte)0, 1 + size / 16);
            Mix(Query.Penetration(a, b, workspace, out p), p);
            Contacts(a, b, size / 8);
        }
    }

    public static ulong HashOf(uint pairs) {
        Golden golden = new Golden();
        for (uint i = 0; i < pairs; i++) golden.Pair();
        return golden.hash;
    }
}
