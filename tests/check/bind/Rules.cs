// What the matches of Match.cs have of their own in space and in the plane.
using Gjk;

namespace Space {
    public static class Rules {
        public const int Wall = 5, Axes = 3, Reach = 3 * Q16.One;

        public static void Configure(ref SceneConfig config) { config.WorkspaceCells = 400; }
        public static Vec3 Up(int height) { return new Vec3(0, 0, height); }
        public static int Along(Vec3 v, int axis) { return axis == 0 ? v.X : axis == 1 ? v.Y : v.Z; }

        public static void Set(ref Vec3 v, int axis, int value) {
            if (axis == 0) v.X = value; else if (axis == 1) v.Y = value; else v.Z = value;
        }

        public static Vec3 Vector(uint slot, uint tick, uint first, int limit) {
            return new Vec3(Match.Roll(slot, tick, first, limit), Match.Roll(slot, tick, first + 1, limit),
                            Match.Roll(slot, tick, first + 2, limit));
        }

        public static Quat Turn(uint slot, uint tick) {
            Vec3 v = Vector(slot, tick, 4, 300);
            return new Quat { X = v.X, Y = v.Y, Z = v.Z, W = 30000 };
        }

        public static int Sum(Manifold m) {
            int sum = m.Normal.X % 5 + m.Normal.Y % 7 + m.Normal.Z % 11 + m.FeatureA + m.FeatureB;
            for (int i = 0; i < m.Count; i++) {
                Contact c = m.Contact(i);
                sum += c.PointA.X % 5 + c.PointA.Y % 7 + c.PointB.Z % 11 + c.Distance % 13 + c.Id;
            }
            return sum;
        }

        static int Units(double units) { return Q16.From(units); }

        public static Shape[] Shapes() {
            Vec3[] corners = {
                new Vec3(30000, 2000, 1000), new Vec3(-28000, 9000, -3000), new Vec3(5000, 31000, 2000),
                new Vec3(-3000, -30000, 4000), new Vec3(1000, 2000, 33000), new Vec3(-2000, 900, -31000),
                new Vec3(20000, 20000, 12000), new Vec3(-19000, -18000, -9000)
            };
            return new Shape[] {
                Shape.Box(new Vec3(Units(0.5), Units(0.5), Units(0.5))), Shape.Sphere(Units(0.5)),
                Shape.Capsule(Units(0.25), Units(0.4)), Shape.Hull(corners), Shape.Cylinder(Units(0.5), Units(0.375)),
                Shape.Box(new Vec3(Units(6), Units(6), Units(0.25)))
            };
        }
    }
}

namespace Flat {
    using Gjk.Plane;

    public static class Rules {
        public const int Wall = 6, Axes = 2, Reach = 4 * Q16.One;

        public static void Configure(ref SceneConfig config) { }
        public static Vec Up(int height) { return new Vec(0, height); }
        public static int Along(Vec v, int axis) { return axis == 0 ? v.X : v.Y; }
        public static void Set(ref Vec v, int axis, int value) { if (axis == 0) v.X = value; else v.Y = value; }

        public static Vec Vector(uint slot, uint tick, uint first, int limit) {
            return new Vec(Match.Roll(slot, tick, first, limit), Match.Roll(slot, tick, first + 1, limit));
        }

        public static Rotation Turn(uint slot, uint tick) {
            return new Rotation { C = 30000, S = Match.Roll(slot, tick, 4, 500) };
        }

        public static int Sum(Manifold m) {
            int sum = m.Normal.X % 5 + m.Normal.Y % 7 + m.FeatureA + m.FeatureB;
            for (int i = 0; i < m.Count; i++) {
                Contact c = m.Contact(i);
                sum += c.PointA.X % 5 + c.PointA.Y % 7 + c.PointB.X % 11 + c.Distance % 13 + c.Id;
            }
            return sum;
        }

        static int Units(double units) { return Q16.From(units); }

        public static Shape[] Shapes() {
            Vec[] corners = {
                new Vec(30000, 2000), new Vec(9000, 29000), new Vec(-25000, 20000), new Vec(-28000, -9000), new Vec(-3000, -30000),
                new Vec(19000, -18000)
            };
            Vec[] sail = { new Vec(-40000, -9000), new Vec(41000, 0), new Vec(3000, 52000) };
            return new Shape[] {
                Shape.Box(new Vec(Units(0.5), Units(0.5))), Shape.Circle(Units(0.5)), Shape.Capsule(Units(0.25), Units(0.4)),
                Shape.Polygon(corners), Shape.Ellipse(new Vec(Units(0.5), Units(0.375))), Shape.Triangle(sail),
                Shape.Box(new Vec(Units(6), Units(0.25)))
            };
        }
    }
}
