"""Plants whose diagnosis is timed: each with what is concealed in its recordings, the step of its solver and its naive model.

The equations of the gyrosphere are those of Potemkin (1978), (2.1) and (2.3), as the built-in model has them.
"""

import math
from dataclasses import dataclass, field

import numpy as np


@dataclass
class Plant:
    name: str
    rate: float  # samples a second
    samples: int
    inputs: dict  # name: (unit, values)
    start: list
    law: object  # concealed -> f(x, u) -> rates
    outputs: dict  # name: (unit, noise, f(x))
    model: str
    cases: list
    substeps: int = 2
    models: dict = field(default_factory=dict)  # of a case that has a naive model of its own
    senses: object = lambda hidden, clean, x: clean  # what a sensor makes of an output, of the states at each sample


def wave(rng, n, rate, low, high, rms):
    """Gaussian noise in a band, rad/s."""
    lines = np.fft.rfft(rng.standard_normal(n))
    w = 2 * np.pi * np.fft.rfftfreq(n, 1 / rate)
    lines[(w < low) | (w > high)] = 0
    x = np.fft.irfft(lines, n)
    return rms * x / x.std()


def levels(rng, n, every, top):
    """A new level now and then, smoothed over some samples."""
    x = np.repeat(rng.uniform(-top, top, n // every + 1), every)[:n]
    return np.convolve(np.pad(x, (20, 20), "edge"), np.ones(21) / 21, "same")[20:-20]


GYROSPHERE = '''extends = "gyrosphere"
name = "gyrosphere in a seaway"
'''
PRECESSION = '''extends = "gyrosphere-precession"
name = "gyrosphere in a seaway, rigid"
'''


def gyrosphere(rng) -> Plant:
    rate, n = 10.0, 54_000
    roll = wave(rng, n, rate, 0.6, 1.1, 0.05)
    pitch = wave(rng, n, rate, 0.7, 1.4, 0.04)
    heading = np.repeat(rng.uniform(20, 340, 9), n // 9)
    heading = np.convolve(np.pad(heading, (600, 600), "edge"), np.ones(1201) / 1201, "same")[600:-600]
    h_ang, g, u, lat, lp, c, f = 1.55e8, 981, 7.2921e-5, math.radians(46.5), 4.757e6, 1.9028e6, 1.5e-3
    p, c0, t, h = 8.5e6, 1.35e8, 0.44, 300

    def law(hidden):
        gap, stop, lever = (3e-4 if hidden == "free play" else 0), 1.2e-3, (400 if hidden == "pitch" else 0)

        def rates(x, v):
            beta, azimuth, lam, shift, speed = x
            roll_acc, deg, pitch_acc = v
            s, co = math.sin(math.radians(deg)), math.cos(math.radians(deg))
            w1, w2 = -h * roll_acc * co - lever * pitch_acc * s, h * roll_acc * s - lever * pitch_acc * co
            felt = max(shift - gap, 0) + min(shift + gap, 0)
            slide, fast = (p * w1 / (g * c0) - shift) / t, 0.0
            if hidden == "stop" and abs(shift) > stop and slide * shift > 0:
                slide = -(abs(shift) - stop) * math.copysign(20, shift)
            if hidden == "inertia":
                slide, fast = speed, (p * w1 / (g * c0) - shift - t * speed) / 0.06
            return (
                -u * math.cos(lat) * azimuth + p * w2 * felt / (g * h_ang),
                -u * math.sin(lat) + lp / h_ang * beta + c / h_ang * lam + lp * w2 / (h_ang * g),
                -f * (beta + lam + w2 / g),
                slide,
                fast,
            )

        return rates

    inputs = {"roll_acc": ("rad/s^2", roll), "heading": ("deg", heading), "pitch_acc": ("rad/s^2", pitch)}
    return Plant("gyrosphere", rate, n, inputs, [0.002, 0.01, -0.002, 0.0, 0.0], law,
                 {"alpha": ("deg", 0.005, lambda x: math.degrees(x[1]))}, GYROSPHERE,
                 ["nothing", "inertia", "free play", "pitch", "precession alone", "stop"], 4,
                 {"precession alone": PRECESSION})


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


def axis(rng) -> Plant:
    n, rate = 12_000, 200.0
    force = levels(rng, n, 130, 300)
    def senses(hidden, clean, x):
        late = np.concatenate([np.full(12, clean[0]), clean])[:n]
        return {"delay": late, "lag": x[:, 2]}.get(hidden, clean)

    def law(hidden):
        def rates(x, v):
            q, w, lagged, clock = x
            push = v[0]
            if hidden == "saturation":
                push = max(-180, min(180, push))
            drag = 200 * w * (2 if hidden == "damping jumps" and clock > 40 else 1)
            drag += {"dry friction": 25 * math.tanh(w / 1e-3), "square damping": 150 * w * abs(w), "spring": 60 * q,
                     "input offset": -12.0, "wave": -20 * math.sin(2.1 * clock)}.get(hidden, 0.0)
            return w, (push - drag) / 90, (1000 * q - lagged) / 0.05, 1.0

        return rates

    inputs = {"force": ("N", force)}
    return Plant("axis", rate, n, inputs, [0.0, 0.0, 0.0, 0.0], law,
                 {"position": ("mm", 0.5, lambda x: 1000 * x[0])}, AXIS,
                 ["nothing", "dry friction", "square damping", "spring", "delay", "input offset", "wave", "saturation",
                  "damping jumps", "lag"], 4, senses=senses)


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


def cylinder(rng) -> Plant:
    n, rate = 10_000, 500.0
    area, volume, stiff = 12e-4, 6e-4, 8e8

    def law(hidden):
        def rates(x, v):
            s, w, pa, pb = x
            flow = v[0] / 60_000
            leak = 1.5e-12 * (pa - pb) if hidden == "leak" else 0.0
            rub = 150 * math.tanh(w / 1e-3) if hidden == "dry friction" else 0.0
            into = stiff / volume * (flow - area * w - leak)
            return w, (area * (pa - pb) - 800 * w - rub) / 200, into, -into

        return rates

    outputs = {"stroke": ("mm", 0.05, lambda x: 1000 * x[0]), "head": ("bar", 0.1, lambda x: x[2] / 1e5),
               "rod": ("bar", 0.1, lambda x: x[3] / 1e5)}
    return Plant("cylinder", rate, n, {"valve": ("dm^3/min", levels(rng, n, 220, 8))}, [0.0, 0.0, 30e5, 30e5], law, outputs,
                 CYLINDER, ["nothing", "leak", "dry friction"], 4)


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


def speaker(rng) -> Plant:
    n, rate = 12_000, 8_000.0

    def law(hidden):
        def rates(x, v):
            i, s, w = x
            force = 5.8 * (1 - 2e4 * s * s if hidden == "force factor" else 1)
            spring = 1500 * s * (1 + 8e4 * s * s if hidden == "stiffening" else 1)
            return (v[0] - 6.0 * i - force * w) / 0.45e-3, w, (force * i - spring - 1.2 * w) / 0.014

        return rates

    outputs = {"current": ("A", 0.003, lambda x: x[0]), "excursion": ("mm", 0.01, lambda x: 1000 * x[1])}
    return Plant("loudspeaker", rate, n, {"voltage": ("V", wave(rng, n, rate, 60, 2500, 6.0))}, [0.0, 0.0, 0.0], law,
                 outputs, SPEAKER, ["nothing", "stiffening", "force factor"], 4)


PLANTS = [gyrosphere, axis, cylinder, speaker]
