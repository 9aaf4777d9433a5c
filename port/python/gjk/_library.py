"""The shared library, statuses, numbers, and what the structures of space and of the plane have in common."""

import ctypes
import enum
import os
import pathlib


class Status(enum.IntEnum):
    """gjk_status: what a call reports about itself. gjk/status.h says when."""

    OK = 0
    NULL = -1
    SIZE = -2
    NEGATIVE = -3
    EMPTY = -4
    CAPACITY = -5
    OVERLAP = -6
    ROTATION = -7
    RANGE = -8
    UNINITIALISED = -9
    ITERATION_LIMIT = -10
    UNPROVEN = -11
    UNSUPPORTED = -12
    BODY_ID = -13
    BUSY = -14
    CORRUPT = -15


class Error(Exception):
    """A call whose status is not OK.

    status: a Status.
    result: what the call has written; None where a call has no result. After ITERATION_LIMIT and CAPACITY the fields
    that the header of the query names are proven, and safe to act on.
    """

    def __init__(self, status, result=None):
        super().__init__(Status(status).name)
        self.status = Status(status)
        self.result = result


# Numbers. Lengths are Q16.16 integers, unit vectors and fractions Q2.30, angles Q16.16 radians; no call takes a float.

Q16_ONE = 1 << 16
Q30_ONE = 1 << 30


def q16(units):
    """A length in units as an integer of 2^-16, to the nearest; a half goes away from zero, as by GJK_Q16."""
    return _to_integer(units * Q16_ONE)


def q30(value):
    """A number from -2 to 2 as an integer of 2^-30, as by GJK_Q30."""
    return _to_integer(value * Q30_ONE)


def angle(radians):
    """An angle as an integer of 2^-16 radians, as by GJK_ANGLE."""
    return _to_integer(radians * Q16_ONE)


def units(length):
    """A length as a float; exact."""
    return length / Q16_ONE


def _to_integer(x):
    return checked(int(x - 0.5 if x < 0 else x + 0.5), "int32", -(1 << 31), (1 << 31) - 1)


def checked(value, name, least, most):
    """An integer within a range: ctypes by itself would cut off what leaves it."""
    if not isinstance(value, int):
        raise TypeError(f"{value!r} is no integer; lengths are made by q16()")
    if not least <= value <= most:
        raise OverflowError(f"{value} is no {name}")
    return value


def _integer(name, ctype, least, most):
    """A type of argument: an integer that fits."""

    def from_param(_, value):
        return ctype(checked(value, name, least, most))

    return type(name, (), {"from_param": classmethod(from_param)})


Int32 = _integer("int32", ctypes.c_int32, -(1 << 31), (1 << 31) - 1)
Uint8 = _integer("uint8", ctypes.c_uint8, 0, 255)
Uint16 = _integer("uint16", ctypes.c_uint16, 0, 65535)
Uint32 = _integer("uint32", ctypes.c_uint32, 0, (1 << 32) - 1)
Unsigned = _integer("unsigned", ctypes.c_uint, 0, 65535)


class Record(ctypes.Structure):
    """A structure of the library, field by field. C_NAME, which a class states, is its name in C."""

    def __setattr__(self, name, value):
        before = getattr(self, name, None)
        super().__setattr__(name, value)
        if isinstance(value, int) and getattr(self, name) != value:
            super().__setattr__(name, before)
            raise OverflowError(f"{type(self).__name__}.{name} cannot be {value}")

    def __repr__(self):
        shown = (f"{name}={value!r}" for name, value in self.values())
        return f"{type(self).__name__}({', '.join(shown)})"

    def __eq__(self, other):
        return type(self) is type(other) and list(self.values()) == list(other.values())

    __hash__ = None

    def values(self):
        """Its fields: pairs of name and value."""
        for name, _ in self._fields_:
            value = getattr(self, name)
            yield name, list(value) if isinstance(value, ctypes.Array) else value


class Vector(Record):
    """A record of numbers alone, which unpacks like a tuple. Calls take any sequence of as many integers for it."""

    def __iter__(self):
        return (getattr(self, name) for name, _ in self._fields_)

    @classmethod
    def of(cls, value):
        return value if isinstance(value, cls) else cls(*value)

    @classmethod
    def from_param(cls, value):
        return ctypes.byref(cls.of(value))

    @classmethod
    def array(cls, values):
        values = [cls.of(value) for value in values]
        return (cls * len(values))(*values)


class Certificates(Record):
    """What certificates of space and of the plane have in common."""

    @property
    def pairs(self):
        """The vertices of A and of B that the proof names, in pairs."""
        return [(self.a[i], self.b[i]) for i in range(self.count)]


def _find():
    """GJK_LIBRARY, or the library in the nearest folder above this module, which `make install` has put it in, or the
    system's."""
    named = os.environ.get("GJK_LIBRARY")
    if named:
        return named
    for folder in pathlib.Path(__file__).resolve().parents:
        if (folder / "libgjk.so").exists():
            return str(folder / "libgjk.so")
    return "libgjk.so"


try:
    library = ctypes.CDLL(_find())
except OSError as error:
    raise ImportError(
        f"{error}: `make install PREFIX=...` puts the shared library in its place; or GJK_LIBRARY names it"
    ) from error
library.gjk_size_of.restype = ctypes.c_size_t
library.gjk_size_of.argtypes = [ctypes.c_char_p]
library.gjk_constant.argtypes = [ctypes.c_char_p, ctypes.POINTER(ctypes.c_int64)]


def constant(name):
    """The value of a constant of the headers in this build of the library: constant("GJK_CONTACTS_MAX")."""
    value = ctypes.c_int64()
    status = library.gjk_constant(name.encode(), value)
    if status != Status.OK:
        raise KeyError(name)
    return value.value


def size_of(structure):
    """The bytes of a structure of the headers: size_of("gjk_epa_cell")."""
    return library.gjk_size_of(structure.encode())


def check_sizes(names):
    """The library must have been built of the same structures as those among these names of a module."""
    for record in names.values():
        name = vars(record).get("C_NAME") if isinstance(record, type) else None
        if name is not None and size_of(name) != ctypes.sizeof(record):
            raise ImportError(f"{library._name} has another {name}: it is of another version than this module")


def declare(name, *arguments):
    """A function of the library that returns a status, with the types of its arguments."""
    function = library[name]
    function.argtypes = arguments
    return function


def do(function, *arguments):
    """Calls a function without a result."""
    status = function(*arguments)
    if status != Status.OK:
        raise Error(status)


def answer(function, result, *arguments):
    """Calls a function whose last argument is its result, and returns that."""
    out = result()
    status = function(*arguments, out)
    if status != Status.OK:
        raise Error(status, out)
    return out
