"""vision.py - how far apart two colours are for people of each kind of colour vision: CIE 1976 distances of what they see
(Machado, Oliveira & Fernandes 2009, complete dichromacy)."""
import math

KINDS = {
    "all cones": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    "protanopia": ((0.152286, 1.052583, -0.204868), (0.114503, 0.786281, 0.099216), (-0.003882, -0.048116, 1.051998)),
    "deuteranopia": ((0.367322, 0.860646, -0.227968), (0.280085, 0.672501, 0.047413), (-0.011820, 0.042940, 0.968881)),
    "tritanopia": ((1.255528, -0.076749, -0.178779), (-0.078411, 0.930809, 0.147602), (0.004733, 0.691367, 0.303900)),
}


def linear(value):
    part = value / 255
    return part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4


def lab(rgb):
    r, g, b = rgb
    white = (0.95047, 1, 1.08883)
    xyz = (0.4124 * r + 0.3576 * g + 0.1805 * b, 0.2126 * r + 0.7152 * g + 0.0722 * b, 0.0193 * r + 0.1192 * g + 0.9505 * b)
    x, y, z = (t ** (1 / 3) if t > 0.008856 else 7.787 * t + 16 / 116 for t in (v / w for v, w in zip(xyz, white)))
    return 116 * y - 16, 500 * (x - y), 200 * (y - z)


def distance(a, b, kind):
    """Of two colours "#rrggbb", for one of KINDS."""
    seen = []
    for tone in (a, b):
        rgb = [linear(int(tone[i:i + 2], 16)) for i in (1, 3, 5)]
        seen.append(lab([min(1, max(0, sum(m * v for m, v in zip(row, rgb)))) for row in KINDS[kind]]))
    return math.dist(*seen)
