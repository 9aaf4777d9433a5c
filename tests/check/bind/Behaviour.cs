// The C# classes: golden hashes, the layout of structures, errors, saves, and that no call allocates. The first argument says which.
using System;
using System.Reflection;
using System.Runtime.InteropServices;
using Gjk;

public static class Behaviour {
    public static int Main(string[] arguments) {
        switch (arguments[0]) {
            case "golden": return Judge.Run(arguments, Golden.HashOf);
            case "scene": return Judge.Run(arguments, Space.Match.HashOf);
            case "plane": return Judge.Run(arguments, Flat.Match.HashOf);
            case "layout": PrintLayout(); return 0;
            default: Errors(); Scenes(); Allocations(); return 0;
        }
    }

    // Size and offsets of each structure, in the order of their declaration, as NAME NUMBER.
    static void PrintLayout() {
        foreach (Type type in typeof(Native).Assembly.GetTypes()) {
            if (!type.IsValueType || type.IsEnum || type.IsNested || type == typeof(Bool)) continue;
            Console.WriteLine("{0} {1}", type.FullName, Marshal.SizeOf(type));
            foreach (FieldInfo field in type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic)) {
                Console.WriteLine("{0}.{1} {2}", type.FullName, field.Name, Marshal.OffsetOf(type, field.Name));
            }
        }
    }

    static Status Refusal(Func<object> call) {
        try { call(); } catch (GjkException error) { return error.Status; }
        return Status.Ok;
    }

    static void Errors() {
        Judge.That(Refusal(() => Shape.Sphere(-1)) == Status.ErrorNegative, "negative");
        Judge.That(Refusal(() => Shape.Hull(new Vec3[0])) == Status.ErrorEmpty, "empty");
        Judge.That(Refusal(() => Shape.Hull(new Vec3[65536])) == Status.ErrorRange, "range");
        Shape box = Shape.Box(new Vec3(65536, 65536, 65536));
        Pose bad = Pose.Identity;
        bad.Rotation.W = 5;
        Judge.That(Refusal(() => new Collider(box, bad)) == Status.ErrorRotation, "rotation");
        Collider a = new Collider(box, Pose.Identity), b = new Collider(box, new Pose(new Vec3(200000, 0, 0)));
        box.Dispose();  // the colliders keep its memory
        DistanceResult gap;
        Judge.Fine(Query.Distance(a, b, out gap));
        Judge.That(gap.Distance == 200000 - 131072 && gap.PointA.X == 65536, "gap");
        Judge.Fine(Query.Check(a, b, gap));
        gap.Distance++;
        Judge.That(Query.Check(a, b, gap) == Status.ErrorUnproven, "unproven");
        CastResult cast;
        Judge.Fine(Query.Cast(a, a.Position, b, new Vec3(0, 0, 0), 0, out cast));
        Judge.That(cast.Hit && cast.RestB.X == 131072, "cast");
        a.Dispose();
        try { a.SetPose(Pose.Identity); Judge.That(false, "disposed"); } catch (ObjectDisposedException) { }
        try { new Collider(box, Pose.Identity); Judge.That(false, "disposed shape"); } catch (ObjectDisposedException) { }
    }

    static void Scenes() {
        Scene scene = new Scene(SceneConfig.For(4, Detail.Contacts), Shape.Box(new Vec3(65536, 65536, 65536)));
        Part[] parts = { new Part(0) };
        BodyId a, b;
        Judge.Fine(scene.Add(BodySetup.At(Pose.Identity, BodyKind.Static), parts, out a));
        Judge.Fine(scene.Add(BodySetup.At(new Pose(new Vec3(131072, 0, 0)), BodyKind.Dynamic), parts, out b));
        Judge.That(scene.Add(BodySetup.At(Pose.Identity, BodyKind.Static), parts, out a, 1) == Status.ErrorBodyId, "taken");
        Judge.Fine(scene.SetUser(b, 7));
        byte[] early = new byte[scene.Bytes], sealedSave = new byte[scene.Bytes];
        scene.Save(early);
        Report report;
        Manifold manifold;
        Judge.Fine(scene.Update());
        Judge.That(scene.Next(out report, out manifold) && manifold.Count == 4 && report.UserB == 7, "contacts");
        Judge.That(!scene.Next(out report), "one report");
        Judge.Fine(scene.Seal());
        scene.Save(sealedSave);
        ulong late, again;
        Judge.Fine(scene.GetHash(out late));
        Judge.Fine(scene.Load(early));
        Judge.Fine(scene.Update());
        Judge.Fine(scene.GetHash(out again));
        Judge.That(late == again, "a rollback");
        Judge.Fine(scene.Open(sealedSave));
        Judge.Fine(scene.GetHash(out again));
        Judge.That(late == again, "an opened save");
        sealedSave[100] ^= 1;
        Judge.That(scene.Open(sealedSave) == Status.ErrorCorrupt, "a damaged save");
        Judge.Fine(scene.Load(early));
        SceneHit hit;
        CastResult result;
        bool found;
        Judge.Fine(scene.CastRay(new Vec3(0, 0, 900000), new Vec3(0, 0, 0), SceneFilter.All, out hit, out result, out found));
        Judge.That(found && hit.Body.Slot == 0 && result.PointA.Z == 65536, "a ray");
    }

    // What a game calls every tick, so often that one object of each call would fill the heap many times.
    static void Allocations() {
        Scene scene = new Scene(SceneConfig.For(4, Detail.Contacts), Shape.Box(new Vec3(65536, 65536, 65536)));
        Part[] parts = { new Part(0) };
        BodyId a, b;
        Judge.Fine(scene.Add(BodySetup.At(Pose.Identity, BodyKind.Static), parts, out a));
        Judge.Fine(scene.Add(BodySetup.At(new Pose(new Vec3(131072, 0, 0)), BodyKind.Dynamic), parts, out b));
        Shape box = Shape.Box(new Vec3(65536, 65536, 65536));
        Collider one = new Collider(box, Pose.Identity), other = new Collider(box, new Pose(new Vec3(200000, 0, 0)));
        byte[] save = new byte[scene.Bytes];
        Cache cache = default(Cache);
        GC.Collect();
        int before = GC.CollectionCount(0);
        for (int i = 0; i < 200000; i++) {
            DistanceResult gap;
            Report report;
            Manifold manifold;
            ulong hash;
            one.SetPose(new Pose(new Vec3(i % 100, 0, 0)));
            Query.Distance(one, other, ref cache, out gap);
            scene.Move(b, new Pose(new Vec3(131072 + i % 3, 0, 0)));
            scene.Update();
            while (scene.Next(out report, out manifold)) { }
            if (i % 100 == 0) {
                scene.Save(save);
                scene.GetHash(out hash);
            }
        }
        Judge.That(GC.CollectionCount(0) == before, "a call allocates");
    }
}
