// The match of tests/support/scene/match_rules.h through the C# classes, with saves and rollbacks, of space; the test makes that
// of the plane from it. Rules.cs has what a dimension has of its own.
using System;
using Gjk;

namespace Space {
    public sealed class Match {
        const int Bodies = 24;
        const ulong Prime = 0x100000001B3;
        static readonly Detail[] details = {
            Detail.Distance, Detail.Touch, Detail.Touch, Detail.Distance, Detail.Depth, Detail.Contacts
        };

        struct Mover {
            public BodyId Id;
            public Vec3 Step;
            public Quat Turn;
        }

        struct Saved {
            public Mover[] Movers;
            public byte[] Scene;
            public uint Tick;
            public ulong Sum;
        }

        readonly Mover[] movers = new Mover[Bodies];
        readonly Part[] one = new Part[1], two = new Part[2];
        readonly Scene scene;
        uint tick;

        Match() {
            SceneConfig config = SceneConfig.For(Bodies);
            config.Parts = 2 * Bodies;
            config.OwnPoses = Bodies;
            config.Pairs = 160;
            config.BoxMargin = Q16.From(0.1);
            config.Persist = 1;
            Rules.Configure(ref config);
            scene = new Scene(config, Rules.Shapes());
            two[1] = new Part(1, new Pose(Rules.Up(Q16.From(0.75))));
            for (uint slot = 0; slot < Bodies; slot++) Add(slot);
        }

        static uint Scramble(uint x) {
            x = (x ^ x >> 16) * 0x7FEB352D;
            x = (x ^ x >> 15) * 0x846CA68B;
            return x ^ x >> 16;
        }

        public static int Roll(uint a, uint b, uint c, int limit) {
            return (int)(Scramble(Scramble(Scramble(a) ^ b) ^ c) % (uint)(2 * limit + 1)) - limit;
        }

        static int Bounce(int at, int step) {
            return (at > Rules.Reach && step > 0) || (at < -Rules.Reach && step < 0) ? -step : step;
        }

        void Add(uint slot) {
            bool isFixed = slot == Bodies - 1;
            Part[] parts = slot % 6 == 5 && !isFixed ? two : one;
            parts[0] = new Part(isFixed ? Rules.Wall : (int)slot % Rules.Wall);
            Vec3 at = isFixed ? Rules.Up(-Rules.Reach) : Rules.Vector(slot, tick, 1, Rules.Reach);
            BodySetup setup = BodySetup.At(new Pose(at),
                isFixed ? BodyKind.Static : slot < 2 ? BodyKind.Kinematic : BodyKind.Dynamic);
            setup.Detail = (byte)details[slot % 6];
            setup.User = slot;
            setup.Margin = slot % 4 == 0 ? Q16.From(0.125) : 0;
            movers[slot].Step = slot < 2 ? default(Vec3) : Rules.Vector(slot, tick, 7, 3000);
            Judge.Fine(Quat.Normalize(Rules.Turn(slot, tick), out movers[slot].Turn));
            Judge.Fine(scene.Add(setup, parts, out movers[slot].Id, (int)slot));
        }

        void Move(uint slot, uint input) {
            BodyState state;
            Judge.Fine(scene.Get(movers[slot].Id, out state));
            if (state.Kind == (byte)BodyKind.Static || state.Asleep) return;
            int push = (input & 8) != 0 ? -2000 : 2000;
            for (int axis = 0; axis < Rules.Axes; axis++) {
                int at = Rules.Along(state.Pose.Position, axis);
                int step = Bounce(at, (input & 1u << axis) != 0 ? push : Rules.Along(movers[slot].Step, axis));
                Rules.Set(ref movers[slot].Step, axis, step);
                Rules.Set(ref state.Pose.Position, axis, at + step);
            }
            if (slot >= 2 || (input & 16) != 0) {
                Judge.Fine(Quat.Compose(movers[slot].Turn, state.Pose.Rotation, out state.Pose.Rotation));
            }
            Judge.Fine(scene.Move(movers[slot].Id, state.Pose));
        }

        void Act(uint input) {
            uint slot = 2 + tick % (Bodies - 3);
            if ((input & 32) != 0 && tick % 5 == 0) Judge.Fine(scene.SetShape(movers[slot].Id, 0, (int)tick % Rules.Wall));
            if ((input & 64) != 0 && tick % 7 == 0) {
                Judge.Fine(scene.Remove(movers[slot].Id));
                Add(slot);
            }
            if ((input & 128) != 0 && tick % 3 == 0) {
                BodyState state;
                BodyId id = movers[slot].Id;
                Judge.Fine(scene.Get(id, out state));
                Judge.Fine(state.Asleep ? scene.Wake(id) : scene.Sleep(id));
            }
        }

        void React(Report report, Manifold manifold, bool hasManifold) {
            uint a = report.A.Slot, b = report.B.Slot;
            if (movers[a].Id != report.A || movers[b].Id != report.B) return;
            if (report.Event == (byte)Event.Begin) {
                Vec3 step = movers[a].Step;
                movers[a].Step = movers[b].Step;
                movers[b].Step = step;
            } else if (report.Event == (byte)Event.Persist) {
                movers[b].Step.X += (hasManifold ? Rules.Sum(manifold) : report.Distance) % 7 - 3;
            } else {
                movers[b].Step.Y += report.PartB + 1;
            }
            int x = movers[b].Step.X, y = movers[b].Step.Y;
            movers[b].Step.X = x > 4000 ? 3000 : x < -4000 ? -3000 : x;
            movers[b].Step.Y = y > 4000 ? -3000 : y;
        }

        unsafe void Play(uint first, uint second) {
            for (uint slot = 0; slot < Bodies; slot++) Move(slot, slot == 0 ? first : slot == 1 ? second : 0);
            Act(first);
            Act(second);
            Report report;
            Manifold manifold;
            Judge.Fine(scene.Update());
            while (scene.Next(out report, out manifold)) React(report, manifold, report.Manifold != null);
            tick++;
        }

        ulong Hash() {
            ulong value;
            Judge.Fine(scene.GetHash(out value));
            foreach (Mover mover in movers) {
                for (int axis = 0; axis < Rules.Axes; axis++) value = (value ^ (uint)Rules.Along(mover.Step, axis)) * Prime;
                value = (value ^ mover.Id.Generation) * Prime;
            }
            return value;
        }

        void Save(ref Saved saved, ulong sum) {
            Array.Copy(movers, saved.Movers, Bodies);
            scene.Save(saved.Scene);
            saved.Tick = tick;
            saved.Sum = sum;
        }

        static uint InputOf(uint tick, ulong player) {
            uint any = new Dice(tick * 2ul + player).U32();
            return any & any >> 8 & 0xFF;
        }

        public static ulong HashOf(uint ticks) {
            Match m = new Match();
            Saved saved = new Saved { Movers = new Mover[Bodies], Scene = new byte[m.scene.Bytes] };
            ulong sum = 0xCBF29CE484222325;
            Dice dice = new Dice(3);
            int rollbacks = 0;
            m.Save(ref saved, sum);
            for (uint i = 0; i < ticks; i++) {
                uint what = dice.Below(100);
                if (what < 3 || i - saved.Tick > 30) {
                    m.Save(ref saved, sum);
                } else if (what < 5) {
                    Array.Copy(saved.Movers, m.movers, Bodies);
                    Judge.Fine(m.scene.Load(saved.Scene));
                    m.tick = i = saved.Tick;
                    sum = saved.Sum;
                    rollbacks++;
                }
                m.Play(InputOf(i, 0), InputOf(i, 1));
                sum = (sum ^ m.Hash()) * Prime;
            }
            Judge.That(rollbacks > 0, "no rollback");
            return sum;
        }
    }
}
