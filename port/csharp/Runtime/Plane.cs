// The plane: vectors, poses, shapes, depths and contacts. Its colliders, queries and scenes are made from those of space.
using System;

namespace Gjk.Plane {
    public unsafe partial struct Vec {
        public Vec(int x, int y) { X = x; Y = y; }
        public override string ToString() { return "(" + X + ", " + Y + ")"; }
    }

    public unsafe partial struct Rotation {
        public static readonly Rotation Identity = new Rotation { C = Gjk.Constants.Q30One };

        /// <summary>By an angle, Q16.16 radians.</summary>
        public static Status Angle(int angle, out Rotation result) {
            fixed (Rotation* to = &result) return Native.gjk2_rotation_from_angle(angle, to);
        }

        public static Status Normalize(Rotation r, out Rotation result) {
            fixed (Rotation* to = &result) return Native.gjk2_rotation_normalize(&r, to);
        }

        /// <summary>First b, then a.</summary>
        public static Status Compose(Rotation a, Rotation b, out Rotation result) {
            fixed (Rotation* to = &result) return Native.gjk2_rotation_compose(&a, &b, to);
        }
    }

    public unsafe partial struct Pose {
        public static readonly Pose Identity = new Pose(new Vec(0, 0));
        public Pose(Vec position) { Position = position; Rotation = Gjk.Plane.Rotation.Identity; }
        public Pose(Vec position, Rotation rotation) { Position = position; Rotation = rotation; }
    }

    public sealed unsafe partial class Shape {
        public static Shape Circle(int radius) {
            Shape made = new Shape(none);
            return made.Made(Native.gjk2_shape_point(radius, made.Data));
        }

        /// <summary>Along x.</summary>
        public static Shape Capsule(int radius, int half) {
            Shape made = new Shape(none);
            return made.Made(Native.gjk2_shape_segment(half, radius, made.Data));
        }

        public static Shape Box(Vec half, int radius = 0) {
            Shape made = new Shape(none);
            return made.Made(Native.gjk2_shape_box(half.X, half.Y, radius, made.Data));
        }

        public static Shape Ellipse(Vec radii, int radius = 0) {
            Shape made = new Shape(none);
            return made.Made(Native.gjk2_shape_ellipse(radii.X, radii.Y, radius, made.Data));
        }

        public static Shape Triangle(Vec[] vertices, int radius = 0) {
            if (CountOf(vertices) != 3) throw new GjkException(Status.ErrorRange);
            Shape made = new Shape(vertices);
            return made.Made(Native.gjk2_shape_triangle(made.vertices, radius, made.Data));
        }

        /// <summary>The convex polygon around vertices in any order.</summary>
        public static Shape Polygon(Vec[] vertices, int radius = 0) {
            ushort count = CountOf(vertices);
            Shape made = new Shape(vertices);
            return made.Made(Native.gjk2_shape_polygon(made.vertices, count, radius, made.Data));
        }
    }

    public static unsafe partial class Query {
        public static Status Penetration(Collider a, Collider b, out PenetrationResult result) {
            fixed (PenetrationResult* to = &result) return Native.gjk2_penetration(a.Data, b.Data, null, to);
        }

        public static Status SignedDistance(Collider a, Collider b, out DistanceResult result) {
            fixed (DistanceResult* to = &result) return Native.gjk2_signed_distance(a.Data, b.Data, null, to);
        }

        /// <param name="most">Contacts, 1 or 2.</param>
        public static Status Contacts(Collider a, Collider b, int margin, int most, out Manifold result) {
            fixed (Manifold* to = &result) return Native.gjk2_contacts(a.Data, b.Data, margin, (uint)most, null, to);
        }
    }

    public sealed unsafe partial class Scene {
        static long Cells(SceneConfig config) { return 0; }

        SceneBindings Bind(SceneConfig config, byte* memory) {
            SceneBindings bindings;
            Native.gjk2_scene_bind_all(&bindings);
            bindings.Manifolds = manifolds;
            return bindings;
        }
    }
}
