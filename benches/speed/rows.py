"""Plants whose diagnosis is timed, as fields of benches/fields; `hidden` says what is concealed.

The equations of the gyrosphere are those of Potemkin (1978), (2.1) and (2.3), as the built-in model has them.
"""

import math

import numpy as np

from fields import Field

RAD = math.pi / 180


def hiding(*names: str) -> dict:
    return {name: ({"hidden": name}, frozenset()) for name in names}


def wave(low: float, high: float, rms: float):
    """Gaussian noise in a band, rad/s."""

    def of(t, r):
        lines = np.fft.rfft(r.standard_normal(t.size))
        w = 2 * np.pi * np.fft.rfftfreq(t.size, t[1] - t[0])
        lines[(w < low) | (w > high)] = 0
        x = np.fft.irfft(lines, t.size)
        return rms * x / x.std()

    return of


def levels(every: int, low: float, high: float, edge: int):
    """A new level now and then, reached in so many samples."""

    def of(t, r):
        x = np.repeat(r.uniform(low, high, t.size // every + 1), every)[: t.size]
        return np.convolve(np.pad(x, edge // 2, "edge"), np.ones(edge) / edge, "valid")

    return of


def gyrosphere(x, u, p):
    beta, azimuth, lam, shift, speed = x
    roll_acc, deg, pitch_acc = u
    h_ang, g, earth, lat, lp, c, f = 1.55e8, 981, 7.2921e-5, 46.5 * RAD, 4.757e6, 1.9028e6, 1.5e-3
    weight, c0, lag, h = 8.5e6, 1.35e8, 0.44, 300
    hidden = p["hidden"]
    gap, lever = (3e-4 if hidden == "free play" else 0), (400 if hidden == "pitch" else 0)
    s, co = math.sin(deg * RAD), math.cos(deg * RAD)
    w1, w2 = -h * roll_acc * co - lever * pitch_acc * s, h * roll_acc * s - lever * pitch_acc * co
    felt = max(shift - gap, 0) + min(shift + gap, 0)
    slide, fast = (weight * w1 / (g * c0) - shift) / lag, 0.0
    if hidden == "stop" and abs(shift) > 1.2e-3 and slide * shift > 0:
        slide = -(abs(shift) - 1.2e-3) * math.copysign(20, shift)
    if hidden == "inertia":
        slide, fast = speed, (weight * w1 / (g * c0) - shift - lag * speed) / 0.06
    return [
        -earth * math.cos(lat) * azimuth + weight * w2 * felt / (g * h_ang),
        -earth * math.sin(lat) + lp / h_ang * beta + c / h_ang * lam + lp * w2 / (h_ang * g),
        -f * (beta + lam + w2 / g),
        slide,
        fast,
    ]


def compass(name: str, model: str, *hidden: str) -> Field:
    inputs = {"roll_acc": ("rad/s^2", wave(0.6, 1.1, 0.05)), "heading": ("deg", levels(6000, 20, 340, 1201))}
    return Field(
        name, "Potemkin (1978)", 0.1, 54_000, inputs, [0.002, 0.01, -0.002, 0.0, 0.0], gyrosphere,
        {"alpha": ("deg", lambda x, u, p: x[1] / RAD, 0.02)}, model, hiding(*hidden),
        {"pitch_acc": ("rad/s^2", wave(0.7, 1.4, 0.04))},
    )


def axis(x, u, p):
    q, w, lagged, clock = x
    hidden, push = p["hidden"], u[0]
    if hidden == "saturation":
        push = max(-180, min(180, push))
    drag = 200 * w * (2 if hidden == "damping jumps" and clock > 40 else 1)
    drag += {"dry friction": 25 * math.tanh(w / 1e-3), "square damping": 150 * w * abs(w), "spring": 60 * q,
             "input offset": -12.0, "wave": -20 * math.sin(2.1 * clock)}.get(hidden, 0.0)
    return [w, (push - drag) / 90, (q - lagged) / 0.05, 1.0]


def seen(x, u, p):
    late = np.concatenate([np.full(12, x[0][0]), x[0]])[: x[0].size]
    return 1000 * {"delay": late, "lag": x[2]}.get(p["hidden"], x[0])


def cylinder(x, u, p):
    _, w, pa, pb = x
    area, volume, stiff = 12e-4, 6e-4, 8e8
    leak = 1.5e-12 * (pa - pb) if p["hidden"] == "leak" else 0.0
    rub = 150 * math.tanh(w / 1e-3) if p["hidden"] == "dry friction" else 0.0
    into = stiff / volume * (u[0] / 60_000 - area * w - leak)
    return [w, (area * (pa - pb) - 800 * w - rub) / 200, into, -into]


def speaker(x, u, p):
    i, s, w = x
    force = 5.8 * (1 - 2e4 * s * s if p["hidden"] == "force factor" else 1)
    spring = 1500 * s * (1 + 8e4 * s * s if p["hidden"] == "stiffening" else 1)
    return [(u[0] - 6.0 * i - force * w) / 0.45e-3, w, (force * i - spring - 1.2 * w) / 0.014]


GYROSPHERE = '''extends = "gyrosphere"
name = "gyrosphere in a seaway"
'''
PRECESSION = '''extends = "gyrosphere-precession"
name = "gyrosphere in a seaway, rigid"
'''
AXIS = '''name = "axis"
[inputs]
force = { unit = "N" }
[parameters]
M = { value = 80, unit = "kg", fit = true, min = 1, max = 1000 }
Fv = { value = 150, unit = "N*s/m", fit = true, min = 0, max = 1e4 }
[states]
q = { rate = "v", unit = "m", initial = "fit" }
v = { rate = "(force - Fv*v)/M", unit = "m/s", initial = "fit" }
[outputs]
position = { equals = "q", unit = "mm" }
'''
CYLINDER = '''name = "hydraulic cylinder"
[inputs]
valve = { unit = "dm^3/min" }
[parameters]
A = { value = 12, unit = "cm^2" }
V = { value = 600, unit = "cm^3" }
E = { value = 9000, unit = "bar", fit = true, min = 1000, max = 30000 }
m = { value = 180, unit = "kg", fit = true, min = 10, max = 2000 }
d = { value = 700, unit = "N*s/m", fit = true, min = 0, max = 1e5 }
[states]
s = { rate = "w", unit = "mm", initial = "fit" }
w = { rate = "(A*(pa - pb) - d*w)/m", unit = "mm/s", initial = "fit" }
pa = { rate = "E/V*(valve - A*w)", unit = "bar", initial = "fit" }
pb = { rate = "E/V*(A*w - valve)", unit = "bar", initial = "fit" }
[outputs]
stroke = { equals = "s", unit = "mm" }
head = { equals = "pa", unit = "bar" }
rod = { equals = "pb", unit = "bar" }
'''
SPEAKER = '''name = "loudspeaker"
[inputs]
voltage = { unit = "V" }
[parameters]
R = { value = 6.2, unit = "ohm", fit = true, min = 1, max = 100 }
L = { value = 5e-4, unit = "V*s/A", fit = true, min = 1e-5, max = 1e-2 }
Bl = { value = 5.5, unit = "N/A", fit = true, min = 0.1, max = 100 }
m = { value = 14, unit = "g" }
k = { value = 1.6, unit = "N/mm", fit = true, min = 0.1, max = 100 }
r = { value = 1.4, unit = "N*s/m", fit = true, min = 0, max = 100 }
[states]
i = { rate = "(voltage - R*i - Bl*v)/L", unit = "A", initial = "fit" }
x = { rate = "v", unit = "mm", initial = "fit" }
v = { rate = "(Bl*i - k*x - r*v)/m", unit = "m/s", initial = "fit" }
[outputs]
current = { equals = "i", unit = "A" }
excursion = { equals = "x", unit = "mm" }
'''

DEN_HARTOG = "Den Hartog, Mechanical Vibrations (1956)"
ALL = [
    compass("gyrosphere", GYROSPHERE, "nothing", "inertia", "free play", "pitch", "stop"),
    compass("gyrosphere of precession", PRECESSION, "elastic part"),
    Field("axis", DEN_HARTOG, 0.005, 12_000, {"force": ("N", levels(130, -300, 300, 21))}, [0.0] * 4, axis,
          {"position": ("mm", seen, 0.001)}, AXIS,
          hiding("nothing", "dry friction", "square damping", "spring", "delay", "input offset", "wave", "saturation",
                 "damping jumps", "lag")),
    Field("cylinder", "Merritt, Hydraulic Control Systems (1967)", 0.002, 10_000,
          {"valve": ("dm^3/min", levels(220, -8, 8, 21))}, [0.0, 0.0, 30e5, 30e5], cylinder,
          {"stroke": ("mm", lambda x, u, p: 1000 * x[0], 0.002), "head": ("bar", lambda x, u, p: x[2] / 1e5, 0.01),
           "rod": ("bar", lambda x, u, p: x[3] / 1e5, 0.01)}, CYLINDER, hiding("nothing", "leak", "dry friction")),
    Field("loudspeaker", "Klippel, J. Audio Eng. Soc. 54 (2006) 907", 1 / 8000, 12_000,
          {"voltage": ("V", wave(60, 2500, 6.0))}, [0.0] * 3, speaker,
          {"current": ("A", lambda x, u, p: x[0], 0.01), "excursion": ("mm", lambda x, u, p: 1000 * x[1], 0.01)},
          SPEAKER, hiding("nothing", "stiffening", "force factor")),
]
