"""What the golden sets of space and of the plane have in common."""

import gjk

MASK = (1 << 64) - 1


class Random:
    """splitmix64, as tests/support/random.h."""

    def __init__(self, seed):
        self.word = seed

    def u32(self):
        self.word = (self.word + 0x9E3779B97F4A7C15) & MASK
        z = self.word
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9 & MASK
        z = (z ^ (z >> 27)) * 0x94D049BB133111EB & MASK
        return (z ^ (z >> 31)) >> 32

    def below(self, bound):
        return self.u32() * bound >> 32

    def range(self, low, high):
        return (self.u32() * (high - low + 1) >> 32) + low

    def vector(self, size, components=3):
        return [self.range(-size, size) for _ in range(components)]


class Hash:
    """FNV-1a over words, as tests/support/fnv.h."""

    def __init__(self):
        self.value = 0xCBF29CE484222325

    def mix(self, *words):
        value = self.value
        for word in words:
            for byte in (word & 0xFFFFFFFF).to_bytes(4, "little"):
                value = (value ^ byte) * 0x100000001B3 & MASK
        self.value = value


def ask(query, *arguments, **named):
    """The status and the result of a query."""
    try:
        return gjk.Status.OK, query(*arguments, **named)
    except gjk.Error as error:
        return error.status, error.result


def toward_zero(x, divisor):
    """The quotient of C."""
    return -(-x // divisor) if x < 0 else x // divisor


def moved(position, normal, by):
    """A position moved against a unit vector."""
    return [p - toward_zero(n * by, gjk.Q30_ONE) for p, n in zip(position, normal)]


class Pair:
    """Two random bodies and the hash of what is asked about them. A subclass makes bodies of its module and asks."""

    module = gjk

    def __init__(self, random, hash):
        self.random, self.hash = random, hash
        self.size = 1 << (3 + random.below(23))
        self.far = random.below(8) == 0
        self.a = self.make_body()
        self.b = self.make_body()

    def within_until(self, distance, iterations):
        status, out = ask(self.module.within_until, self.a, self.b, distance, iterations)
        self.hash.mix(status, out.answer)

    def approach(self, result):
        """Moves B along the normal until the gap is near 0."""
        by = result.distance + self.random.range(-2, 2)
        self.b.move(moved(self.b.position, result.normal, by))
        self.hash.mix(gjk.Status.OK)

    def query_at_rest(self, cache):
        """What is asked first. Returns the distance."""
        result = self.distance(None)
        self.decision(-1, None)
        self.decision(result.distance, None)
        result = self.distance(cache)
        self.penetration(cache)
        return result

    def query_close(self, cache, result):
        """What is asked when B has moved along the normal."""
        self.approach(result)
        result = self.distance(cache)
        self.decision(-1, cache)
        self.decision(1, None)
        self.within_until(1 + self.size // 32, 1)
        self.within_until(result.distance, 2)
        self.distance_until(2, 0)
        self.distance_until(0, 1 + self.size // 16)
        self.penetration(None)


def main(pair, seed, arguments, end=lambda hash, last: None):
    """Prints the hash over so many pairs. 0: it is the one expected."""
    pairs, expected = int(arguments[0]), int(arguments[1], 16)
    random, hash = Random(seed), Hash()
    for _ in range(pairs):
        last = pair(random, hash)
        last.query()
    end(hash, last)
    print(f"{hash.value:016x}")
    return int(hash.value != expected)
