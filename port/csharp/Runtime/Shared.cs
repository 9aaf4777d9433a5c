// Shapes at poses, queries and scenes, of space; `make package` writes the plane's from it. No call allocates: what it needs is
// made with the object that it is called of.
using System;
using System.Runtime.InteropServices;

namespace Gjk {
    /// <summary>Geometry in its own frame, with a copy of its vertices. Colliders and scenes that have it keep its memory.</summary>
    public sealed unsafe partial class Shape : Block {
        internal readonly ShapeData* Data;
        readonly Vec3* vertices;

        Shape(Vec3[] points) {
            Data = (ShapeData*)Allocate(sizeof(ShapeData) + (long)sizeof(Vec3) * points.Length);
            vertices = (Vec3*)(Data + 1);
            for (int i = 0; i < points.Length; i++) vertices[i] = points[i];
        }

        static readonly Vec3[] none = new Vec3[0];

        static ushort CountOf(Vec3[] vertices) {
            if (vertices.Length > ushort.MaxValue) throw new GjkException(Status.ErrorRange);
            return (ushort)vertices.Length;
        }

        Shape Made(Status status) {
            if (status != Status.Ok) Dispose();
            GjkException.ThrowUnless(status);
            return this;
        }
    }

    /// <summary>A shape at a pose.</summary>
    public sealed unsafe class Collider : Block {
        readonly ColliderData* data;
        public readonly Shape Shape;

        /// <param name="baked">Poses all vertices of a hull at once, instead of in each query.</param>
        public Collider(Shape shape, Pose pose, bool baked = false) {
            Shape = shape;
            int room = baked ? shape.Data->Count : 0;
            data = (ColliderData*)Allocate(sizeof(ColliderData) + (long)sizeof(Vec3) * room, shape);
            Vec3* buffer = baked ? (Vec3*)(data + 1) : null;
            Status status = Native.gjk_collider_init(data, shape.Data, buffer, (ushort)room);
            if (status == Status.Ok) status = SetPose(pose);
            if (status != Status.Ok) Dispose();
            GjkException.ThrowUnless(status);
        }

        internal ColliderData* Data { get { NotDisposed(); return data; } }

        /// <summary>After an error it stays where it was.</summary>
        public Status SetPose(Pose pose) { return Native.gjk_collider_pose(Data, &pose); }

        /// <summary>Without turning: cheaper than a pose.</summary>
        public Status SetPosition(Vec3 position) { return Native.gjk_collider_move(Data, &position); }

        public Vec3 Position { get { return Data->Position; } }

        public Status GetAabb(out Aabb box) {
            fixed (Aabb* to = &box) return Native.gjk_collider_aabb(Data, to);
        }
    }

    /// <summary>Questions about two colliders. What they answer, how exactly, and with which statuses, stands in the C header
    /// of each name: Distance is gjk_distance. A cache is in and out, and changes nothing but the time.</summary>
    public static unsafe partial class Query {
        public static Status Intersect(Collider a, Collider b, out Decision result) {
            fixed (Decision* to = &result) return Native.gjk_intersect(a.Data, b.Data, null, to);
        }

        public static Status Intersect(Collider a, Collider b, ref Cache cache, out Decision result) {
            fixed (Cache* kept = &cache) fixed (Decision* to = &result) return Native.gjk_intersect(a.Data, b.Data, kept, to);
        }

        public static Status Within(Collider a, Collider b, int most, out Decision result) {
            fixed (Decision* to = &result) return Native.gjk_within(a.Data, b.Data, most, null, to);
        }

        public static Status Within(Collider a, Collider b, int most, ref Cache cache, out Decision result) {
            fixed (Cache* kept = &cache) fixed (Decision* to = &result) return Native.gjk_within(a.Data, b.Data, most, kept, to);
        }

        public static Status WithinUntil(Collider a, Collider b, int most, byte iterations, out WithinResult result) {
            fixed (WithinResult* to = &result) return Native.gjk_within_until(a.Data, b.Data, most, iterations, null, to);
        }

        public static Status Distance(Collider a, Collider b, out DistanceResult result) {
            fixed (DistanceResult* to = &result) return Native.gjk_distance(a.Data, b.Data, null, to);
        }

        public static Status Distance(Collider a, Collider b, ref Cache cache, out DistanceResult result) {
            fixed (Cache* kept = &cache) fixed (DistanceResult* to = &result) return Native.gjk_distance(a.Data, b.Data, kept, to);
        }

        public static Status DistanceUntil(Collider a, Collider b, Effort effort, out DistanceResult result) {
            fixed (DistanceResult* to = &result) return Native.gjk_distance_until(a.Data, b.Data, &effort, null, to);
        }

        /// <param name="toA">Where A's position is at the end of its straight way; its own: it stands.</param>
        public static Status Cast(Collider a, Vec3 toA, Collider b, Vec3 toB, int margin, out CastResult result) {
            CastPath path = new CastPath { ToA = &toA, ToB = &toB, Margin = margin };
            fixed (CastResult* to = &result) return Native.gjk_cast(a.Data, b.Data, &path, to);
        }

        public static Status CastRay(Collider a, Vec3 from, Vec3 end, out CastResult result) {
            fixed (CastResult* to = &result) return Native.gjk_cast_ray(a.Data, &from, &end, to);
        }

        public static Status TimeOfImpact(Collider a, Motion motionA, Collider b, Motion motionB, ImpactSetup setup,
                                          out ImpactResult result) {
            fixed (ImpactResult* to = &result) {
                return Native.gjk_time_of_impact(a.Data, &motionA, b.Data, &motionB, &setup, to);
            }
        }

        /// <summary>Proves an answer in integers: ErrorUnproven where it is not true.</summary>
        public static Status Check(Collider a, Collider b, DistanceResult result) {
            return Native.gjk_check_distance(a.Data, b.Data, &result);
        }

        public static Status Check(Collider a, Collider b, PenetrationResult result) {
            return Native.gjk_check_penetration(a.Data, b.Data, &result);
        }

        /// <param name="most">0 for a decision of Intersect.</param>
        public static Status Check(Collider a, Collider b, int most, Decision decision) {
            return Native.gjk_check_decision(a.Data, b.Data, most, &decision);
        }
    }

    public unsafe partial struct Part {
        /// <summary>A part at the pose of its body. shape: its number in the scene's table.</summary>
        public Part(int shape) { Shape = checked((ushort)shape); OwnPose = false; Pose = Gjk.Pose.Identity; }

        /// <summary>A part at a pose in the frame of its body.</summary>
        public Part(int shape, Gjk.Pose pose) { Shape = checked((ushort)shape); OwnPose = true; Pose = pose; }
    }

    public unsafe partial struct BodySetup {
        /// <summary>A body of category 1 that meets all others. Parts are given to Scene.Add.</summary>
        public static BodySetup At(Gjk.Pose pose, BodyKind kind) {
            return new BodySetup { Pose = pose, Kind = (byte)kind, Category = 1, Mask = uint.MaxValue };
        }
    }

    public unsafe partial struct SceneConfig {
        /// <summary>For so many bodies, of one part each; the other fields may be set.</summary>
        public static SceneConfig For(int bodies, Detail detail = Gjk.Detail.Touch) {
            uint count = checked((uint)bodies);
            return new SceneConfig { Bodies = count, Parts = count, Pairs = 16 * count, Detail = (byte)detail };
        }
    }

    /// <summary>Many bodies, asked every tick which of them touch: gjk/scene.h.</summary>
    public sealed unsafe partial class Scene : Block {
        const int Room = 64;  // reports of one call of the library

        readonly SceneData* data;
        readonly byte* block;
        readonly ShapeData** table;
        readonly Report* reports;
        readonly Manifold* manifolds;
        readonly Shape[] shapes;
        int next;
        Progress progress;
        Status updated;

        /// <summary>How many bytes its save has.</summary>
        public readonly int Bytes;

        /// <param name="shapes">All that bodies may have; a part names one by its place here.</param>
        public Scene(SceneConfig config, params Shape[] shapes) {
            this.shapes = (Shape[])shapes.Clone();
            long bytes = (long)(ulong)Native.gjk_scene_bytes(&config);
            if (bytes == 0 || bytes > int.MaxValue || shapes.Length > ushort.MaxValue) throw new GjkException(Status.ErrorRange);
            Bytes = (int)bytes;
            long head = (sizeof(SceneData) + Room * (long)(sizeof(Report) + sizeof(Manifold)) + 15) / 16 * 16;
            long cells = Cells(config);
            data = (SceneData*)Allocate(head + (long)sizeof(void*) * shapes.Length + cells + (bytes + 15) / 16 * 16, this.shapes);
            reports = (Report*)(data + 1);
            manifolds = (Manifold*)(reports + Room);
            table = (ShapeData**)((byte*)data + head);
            block = (byte*)(table + shapes.Length) + cells;
            for (int i = 0; i < shapes.Length; i++) table[i] = shapes[i].Data;
            SceneBindings bindings = Bind(config, (byte*)(table + shapes.Length));
            Status status = Native.gjk_scene_init(data, &config, block, (UIntPtr)(ulong)bytes, table, (ushort)shapes.Length, &bindings);
            if (status != Status.Ok) Dispose();
            GjkException.ThrowUnless(status);
        }

        SceneData* Data { get { NotDisposed(); return data; } }

        /// <param name="slot">A stated slot; -1: the lowest free one.</param>
        public Status Add(BodySetup setup, Part[] parts, out BodyId body, int slot = -1) {
            fixed (Part* first = parts) fixed (BodyId* to = &body) {
                setup.Parts = first;
                setup.PartCount = (ushort)parts.Length;
                if (parts.Length > ushort.MaxValue) return Status.ErrorCapacity;
                return slot < 0 ? Native.gjk_scene_add(Data, &setup, to) : Native.gjk_scene_add_at(Data, (uint)slot, &setup, to);
            }
        }

        public Status Remove(BodyId body) { return Native.gjk_scene_remove(Data, body); }

        /// <summary>Moves a body to its next pose, and wakes it.</summary>
        public Status Move(BodyId body, Pose pose) { return Native.gjk_scene_move(Data, body, &pose); }

        /// <summary>As Move, for a body that does not go on the same way.</summary>
        public Status Teleport(BodyId body, Pose pose) { return Native.gjk_scene_teleport(Data, body, &pose); }

        public Status Sleep(BodyId body) { return Native.gjk_scene_sleep(Data, body); }
        public Status Wake(BodyId body) { return Native.gjk_scene_wake(Data, body); }
        public Status SetMotion(BodyId body, BodyMotion motion) { return Native.gjk_scene_set_motion(Data, body, (byte)motion); }

        public Status SetShape(BodyId body, int part, int shape) {
            if ((part | shape) < 0 || part > ushort.MaxValue || shape > ushort.MaxValue) return Status.ErrorRange;
            return Native.gjk_scene_set_shape(Data, body, (ushort)part, (ushort)shape);
        }

        public Status SetFilter(BodyId body, uint category, uint mask) { return Native.gjk_scene_set_filter(Data, body, category, mask); }
        public Status SetUser(BodyId body, uint user) { return Native.gjk_scene_set_user(Data, body, user); }

        public Status Get(BodyId body, out BodyState state) {
            fixed (BodyState* to = &state) return Native.gjk_scene_get(Data, body, to);
        }

        public Status GetStats(out SceneStats stats) {
            fixed (SceneStats* to = &stats) return Native.gjk_scene_get_stats(Data, to);
        }

        /// <summary>Finds which pairs are near, and what fast bodies touch. Next gives the reports; take all of them before bodies
        /// are changed. After ErrorCapacity the update has not begun.</summary>
        public Status Update() {
            Progress now;
            next = 0;
            updated = Native.gjk_scene_update(Data, reports, Room, &now);
            progress = updated == Status.Ok ? now : default(Progress);
            return updated;
        }

        /// <summary>The next report of the update, and its manifold, which has no contacts where there is none.</summary>
        public bool Next(out Report report, out Manifold manifold) {
            while (next == progress.Reports && (progress.ReportsLeft != 0 || progress.PairsLeft != 0)) {
                if (Update() != Status.Ok) break;
            }
            bool more = next < progress.Reports;
            report = more ? reports[next] : default(Report);
            manifold = more && report.Manifold != null ? *report.Manifold : default(Manifold);
            next += more ? 1 : 0;
            return more;
        }

        public bool Next(out Report report) {
            Manifold manifold;
            return Next(out report, out manifold);
        }

        /// <summary>What a ray enters first. found: hit and result are set.</summary>
        public Status CastRay(Vec3 from, Vec3 to, SceneFilter filter, out SceneHit hit, out CastResult result, out bool found) {
            Bool any = false;
            Status status;
            fixed (SceneHit* part = &hit) fixed (CastResult* answer = &result) {
                status = Native.gjk_scene_cast_ray(Data, &from, &to, &filter, part, answer, &any);
            }
            found = any;
            return status;
        }

        /// <summary>What a collider meets first on a straight way.</summary>
        public Status Cast(Collider collider, Vec3 to, int margin, SceneFilter filter, out SceneHit hit, out CastResult result,
                           out bool found) {
            Bool any = false;
            Status status;
            fixed (SceneHit* part = &hit) fixed (CastResult* answer = &result) {
                status = Native.gjk_scene_cast(Data, collider.Data, &to, margin, &filter, part, answer, &any);
            }
            found = any;
            return status;
        }

        /// <summary>All parts that are at most reach away from a collider: how many there are, of which the first are written.</summary>
        public Status Within(Collider collider, int reach, SceneFilter filter, SceneHit[] hits, out int count) {
            uint there = 0;
            Status status;
            fixed (SceneHit* room = hits) {
                status = Native.gjk_scene_query_within(Data, collider.Data, reach, &filter, null, room, (uint)hits.Length, &there);
            }
            count = (int)there;
            return status;
        }

        /// <summary>64 bits over all that decides further answers.</summary>
        public Status GetHash(out ulong hash) {
            fixed (ulong* to = &hash) return Native.gjk_scene_hash(Data, to);
        }

        /// <summary>Copies the scene, for a rollback in this program. save: at least Bytes.</summary>
        public void Save(byte[] save) {
            if (save.Length < Bytes) throw new GjkException(Status.ErrorCapacity);
            Marshal.Copy((IntPtr)Data->Block, save, 0, Bytes);
        }

        /// <summary>Takes what this scene, or one of the same configuration and shapes in this program, has saved.</summary>
        public Status Load(byte[] save) {
            if (save.Length < Bytes) return Status.ErrorCapacity;
            Marshal.Copy(save, 0, (IntPtr)Data->Block, Bytes);
            progress = default(Progress);
            next = 0;
            SceneBindings bindings = data->Bindings;
            return Native.gjk_scene_attach(data, block, (UIntPtr)(uint)Bytes, table, (ushort)shapes.Length, &bindings);
        }

        /// <summary>Marks the scene with a checksum, for a save that leaves this program: then Save, there Open.</summary>
        public Status Seal() { return Native.gjk_scene_seal(Data); }

        /// <summary>Takes a sealed save that may come from anywhere; it is checked. After an error the scene is empty of sense:
        /// Load an own save.</summary>
        public Status Open(byte[] save) {
            if (save.Length != Bytes) return Status.ErrorCapacity;
            Marshal.Copy(save, 0, (IntPtr)Data->Block, Bytes);
            progress = default(Progress);
            next = 0;
            SceneBindings bindings = data->Bindings;
            return Native.gjk_scene_open(data, block, (UIntPtr)(uint)Bytes, table, (ushort)shapes.Length, &bindings);
        }
    }
}
