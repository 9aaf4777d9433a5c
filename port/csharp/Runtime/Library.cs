// What is of neither space nor the plane: the shared library, statuses, numbers, memory.
using System;
using System.Runtime.InteropServices;
using System.Threading;

namespace Gjk {
    /// <summary>A bool of C: one byte.</summary>
    public struct Bool {
        byte value;
        public static implicit operator bool(Bool b) { return b.value != 0; }
        public static implicit operator Bool(bool b) { return new Bool { value = (byte)(b ? 1 : 0) }; }
        public override string ToString() { return value != 0 ? "True" : "False"; }
    }

    /// <summary>What a constructor refuses. Queries return their Status instead.</summary>
    public sealed class GjkException : Exception {
        public readonly Status Status;
        public GjkException(Status status) : base("gjk: " + status) { Status = status; }
        internal static void ThrowUnless(Status status) {
            if (status != Status.Ok) throw new GjkException(status);
        }
    }

    public static unsafe partial class Native {
        // Where IL2CPP compiles gjk.c into the program, it is in no library.
#if ENABLE_IL2CPP && !UNITY_EDITOR
        const string Library = "__Internal";
#else
        const string Library = "gjk";
#endif

        // A library of other structures than these must not be called.
        static void Check(string name, int size) {
            int end = name.Length;
            byte* text = stackalloc byte[end + 1];
            for (int i = 0; i < end; i++) text[i] = (byte)name[i];
            text[end] = 0;
            if ((uint)gjk_size_of(text) != size) throw new TypeLoadException("the library gjk has another " + name);
        }

        static bool isChecked;

        internal static void CheckOnce() {
            if (isChecked) return;
            CheckSizes();
            isChecked = true;
        }
    }

    /// <summary>Numbers: lengths are integers of 2^-16 unit, unit vectors and rotations of 2^-30.</summary>
    public static class Q16 {
        public const int One = Constants.Q16One;

        /// <summary>A length in units as an integer, to the nearest, a half away from zero, as GJK_Q16.</summary>
        public static int From(double units) {
            double scaled = units * 65536.0;
            return checked((int)(scaled < 0 ? scaled - 0.5 : scaled + 0.5));
        }

        /// <summary>A length as a number of units, exactly.</summary>
        public static double ToUnits(int length) { return length / 65536.0; }
    }

    /// <summary>Memory that does not move, for what C points to. Dispose gives it back, once nothing that was made with the object
    /// is left; there is no finalizer, which could run during a call.</summary>
    public abstract unsafe class Block : IDisposable {
        byte* memory;
        bool isDisposed;
        int users = 1;  // this object, and those that were made with it
        Block[] used;

        protected byte* Allocate(long bytes, params Block[] used) {
            Native.CheckOnce();
            foreach (Block block in used) block.NotDisposed();
            foreach (Block block in used) Interlocked.Increment(ref block.users);
            this.used = used;
            memory = (byte*)Marshal.AllocHGlobal(new IntPtr(Math.Max(bytes, 1)));
            for (long i = 0; i < bytes; i++) memory[i] = 0;
            return memory;
        }

        protected void NotDisposed() {
            if (isDisposed) throw new ObjectDisposedException(GetType().Name);
        }

        void Release() {
            if (Interlocked.Decrement(ref users) != 0) return;
            Marshal.FreeHGlobal((IntPtr)memory);
            foreach (Block block in used) block.Release();
        }

        public void Dispose() {
            if (!isDisposed) Release();
            isDisposed = true;
        }
    }

    public unsafe partial struct SceneFilter {
        public static SceneFilter All {
            get { return new SceneFilter { Category = uint.MaxValue, Mask = uint.MaxValue }; }
        }
    }

    public unsafe partial struct BodyId : IEquatable<BodyId> {
        public bool Equals(BodyId other) { return Slot == other.Slot && Generation == other.Generation; }
        public override bool Equals(object other) { return other is BodyId && Equals((BodyId)other); }
        public override int GetHashCode() { return (int)(Slot * 31 + Generation); }
        public static bool operator ==(BodyId a, BodyId b) { return a.Equals(b); }
        public static bool operator !=(BodyId a, BodyId b) { return !a.Equals(b); }
    }
}
