// Random numbers and hashes as those of tests/support, for the npm package.
const MASK = (1n << 64n) - 1n;

export class Random {
  constructor(seed) {
    this.word = seed;
  }

  u32() {
    this.word = this.word + 0x9E3779B97F4A7C15n & MASK;
    let z = this.word;
    z = (z ^ z >> 30n) * 0xBF58476D1CE4E5B9n & MASK;
    z = (z ^ z >> 27n) * 0x94D049BB133111EBn & MASK;
    return Number((z ^ z >> 31n) >> 32n);
  }

  below(bound) {
    return Number(BigInt(this.u32()) * BigInt(bound) >> 32n);
  }

  range(low, high) {
    return low + Number(BigInt(this.u32()) * BigInt(high - low + 1) >> 32n);
  }

  vector(size, count = 3) {
    return Array.from({ length: count }, () => this.range(-size, size));
  }
}

// FNV-1a over the bytes of words.
export class Hash {
  value = 0xCBF29CE484222325n;

  mix(...words) {
    for (const word of words) {
      for (let i = 0; i < 32; i += 8) {
        this.value = (this.value ^ BigInt(word >>> i & 255)) * 0x100000001B3n & MASK;
      }
    }
  }

  text() {
    return this.value.toString(16).padStart(16, '0');
  }
}

// A part of a unit vector times a length, towards zero.
export function along(normal, by) {
  const product = BigInt(normal) * BigInt(by);
  return Number(product / (1n << 30n));
}
