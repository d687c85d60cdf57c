"""Stands for OMPL's own Python bindings where they are not installed: the modules `base` and `util`, with what clearway.ompl
and its tests use, named and typed as in OMPL 2.0.2. test_ompl.py compares it with the bindings where these are installed.

States, spaces and validators take only each other's types, as nanobind does. A state that is handed to a checker is lent: it
is worth nothing after the call.
"""

import math
import types

_NORM_ERROR = 1e-9
warnings = []  # what OMPL_WARN was given


class _Base:
    """A class whose constructor must have run before OMPL takes the object."""

    def __init__(self, si):
        _require(si, SpaceInformation)
        self._is_ready = True


def _require(thing, kind):
    if not isinstance(thing, kind) or not getattr(thing, "_is_ready", True):
        raise TypeError("incompatible function arguments: %r, expected %s" % (thing, kind.__name__))


class State:
    __slots__ = ()


class SO3State(State):
    __slots__ = ("x", "y", "z", "w")

    def setIdentity(self):
        self.x = self.y = self.z = 0.0
        self.w = 1.0

    def setAxisAngle(self, x, y, z, angle):
        scale = math.sin(angle / 2) / math.sqrt(x * x + y * y + z * z)
        self.x, self.y, self.z, self.w = scale * x, scale * y, scale * z, math.cos(angle / 2)


class SE3State(State):
    __slots__ = ("_xyz", "_rotation")

    def __init__(self):
        self._xyz, self._rotation = [0.0] * 3, SO3State()
        self._rotation.setIdentity()

    def getX(self):
        return self._xyz[0]

    def getY(self):
        return self._xyz[1]

    def getZ(self):
        return self._xyz[2]

    def setX(self, x):
        self._xyz[0] = x

    def setXYZ(self, x, y, z):
        self._xyz[:] = x, y, z

    def rotation(self):
        return self._rotation

    def _numbers(self):
        q = self._rotation
        return self._xyz + [q.x, q.y, q.z, q.w]

    def _set(self, numbers):
        self._xyz[:] = numbers[:3]
        q = self._rotation
        q.x, q.y, q.z, q.w = numbers[3:]


class SE2StateType(State):
    __slots__ = ("_values",)

    def __init__(self):
        self._values = [0.0] * 3

    def getX(self):
        return self._values[0]

    def getY(self):
        return self._values[1]

    def getYaw(self):
        return self._values[2]

    def setX(self, x):
        self._values[0] = x

    def setXY(self, x, y):
        self._values[:2] = x, y

    def setYaw(self, yaw):
        self._values[2] = yaw

    def _numbers(self):
        return list(self._values)

    def _set(self, numbers):
        self._values[:] = numbers


class RealVectorStateType(State):
    __slots__ = ("_values",)

    def __init__(self):
        self._values = [0.0] * 2

    def __getitem__(self, i):
        return self._values[i]

    def __setitem__(self, i, value):
        self._values[i] = value

    def _numbers(self):
        return list(self._values)

    def _set(self, numbers):
        self._values[:] = numbers


class RealVectorBounds:
    def __init__(self, dimensions):
        self.low, self.high = [0.0] * dimensions, [0.0] * dimensions

    def setLow(self, low):
        self.low = [float(low)] * len(self.low)

    def setHigh(self, high):
        self.high = [float(high)] * len(self.high)


class StateSpace:
    def getName(self):
        return type(self).__name__ + "1"


class _Bounded(StateSpace):
    """The methods that OMPL binds class by class."""

    def allocState(self):
        return self._state()

    def copyState(self, destination, source):
        for state in (destination, source):
            _require(state, self._state)
        destination._set(source._numbers())

    def setBounds(self, bounds):
        _require(bounds, RealVectorBounds)
        self._bounds = bounds

    def satisfiesBounds(self, state):
        _require(state, self._state)
        least = 2.0**-52
        bounds = zip(state._numbers(), self._bounds.low, self._bounds.high)
        return not any(value - least > high or value + least < low for value, low, high in bounds)


class SE3StateSpace(_Bounded):
    _state = SE3State

    def satisfiesBounds(self, state):
        return super().satisfiesBounds(state) and abs(math.hypot(*state._numbers()[3:]) - 1) < _NORM_ERROR

    def interpolate(self, a, b, time, result):
        """OMPL's slerp, which keeps the first rotation when the product of the two is within 1e-9 of 1."""
        for state in (a, b, result):
            _require(state, SE3State)
        first, second = a._numbers(), b._numbers()
        moved = [p + (q - p) * time for p, q in zip(first[:3], second[:3])]
        product = sum(p * q for p, q in zip(first[3:], second[3:]))
        rotation = first[3:]
        if abs(product) <= 1 - _NORM_ERROR:
            theta = math.acos(abs(product))
            s0, s1 = math.sin((1 - time) * theta), math.copysign(1, product) * math.sin(time * theta)
            rotation = [(p * s0 + q * s1) / math.sin(theta) for p, q in zip(first[3:], second[3:])]
        result._set(moved + rotation)


class SE2StateSpace(_Bounded):
    _state = SE2StateType

    def satisfiesBounds(self, state):
        return super().satisfiesBounds(state) and -math.pi <= state.getYaw() < math.pi

    def interpolate(self, a, b, time, result):
        for state in (a, b, result):
            _require(state, SE2StateType)
        first, second = a._numbers(), b._numbers()
        turn = second[2] - first[2]
        if abs(turn) > math.pi:
            turn -= math.copysign(2 * math.pi, turn)
        yaw = first[2] + turn * time
        if abs(yaw) > math.pi:
            yaw -= math.copysign(2 * math.pi, yaw)
        result._set([p + (q - p) * time for p, q in zip(first[:2], second[:2])] + [yaw])


class DubinsStateSpace(SE2StateSpace):
    def interpolate(self, a, b, time, result):
        raise NotImplementedError("the stand-in knows no Dubins curves")


class RealVectorStateSpace(_Bounded):
    _state = RealVectorStateType

    def __init__(self, dimensions):
        assert dimensions == 2


class StateValidityChecker(_Base):
    pass


class MotionValidator(_Base):
    pass


class SpaceInformation:
    def __init__(self, space):
        _require(space, StateSpace)
        self._space = space

    def getStateSpace(self):
        return self._space

    def setStateValidityChecker(self, svc):
        _require(svc, StateValidityChecker)
        self._checker = svc

    def setMotionValidator(self, validator):
        _require(validator, MotionValidator)
        self._validator = validator

    def getMotionValidator(self):
        return self._validator

    def setup(self):
        pass

    def isValid(self, state):
        return self._lend(self._checker.isValid, state)

    def checkMotion(self, s1, s2):
        return self._lend(self._validator.checkMotion, s1, s2)

    def _lend(self, call, *states):
        """Calls with copies that are worth nothing afterwards."""
        lent = []
        for state in states:
            lent.append(self._space.allocState())
            lent[-1]._set(state._numbers())
        answer = call(*lent)
        for state in lent:
            state._set([math.nan] * len(state._numbers()))
        if type(answer) is not bool:
            raise TypeError("%r is no bool" % (answer,))
        return answer


base = types.ModuleType("ompl.base")
for _thing in (State, SO3State, SE3State, SE2StateType, RealVectorStateType, RealVectorBounds, StateSpace, SE3StateSpace,
               SE2StateSpace, DubinsStateSpace, RealVectorStateSpace, StateValidityChecker, MotionValidator,
               SpaceInformation):
    setattr(base, _thing.__name__, _thing)


def _warn(message):
    if not isinstance(message, str) or message != message.encode("utf-8", "ignore").decode():  # as nanobind
        raise TypeError("incompatible function arguments: %r, expected a text" % message)
    warnings.append(message)


util = types.ModuleType("ompl.util")
util.OMPL_WARN = _warn
