// Random numbers and hashes as those of tests/support.
using System;

public sealed class Dice {
    ulong word;

    public Dice(ulong seed) { word = seed; }

    public uint U32() {
        word += 0x9E3779B97F4A7C15;
        ulong z = word;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
        return (uint)((z ^ (z >> 31)) >> 32);
    }

    public uint Below(uint bound) { return (uint)((ulong)U32() * bound >> 32); }

    public int Range(int low, int high) {
        ulong span = (ulong)((long)high - low + 1);
        return (int)(low + (long)(U32() * span >> 32));
    }
}

public static class Judge {
    /// The arguments are NAME COUNT HASH: the exit status is 0 if the hash over so many is HASH.
    public static int Run(string[] arguments, Func<uint, ulong> hashOf) {
        ulong hash = hashOf(uint.Parse(arguments[1]));
        Console.WriteLine("{0:x16}", hash);
        return hash == Convert.ToUInt64(arguments[2], 16) ? 0 : 1;
    }

    public static void Fine(Gjk.Status status) {
        if (status != Gjk.Status.Ok) throw new Gjk.GjkException(status);
    }

    public static void That(bool condition, string what) {
        if (!condition) throw new Exception(what);
    }
}
