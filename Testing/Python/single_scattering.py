# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Light that media of data scatter once, integrated by brute force in NumPy.

It shares no code with the project, nor with VTK. A view ray, and from each of its places a ray to each light, is cut
where it goes from one cell to another. Between two cuts a trilinear medium is a cubic polynomial of the way, for which
Gauss-Legendre quadrature of two points is exact: so are all optical depths. What is scattered is summed by the same
rule with more points.
"""

import math

import numpy

TINY = 1e-300


class Grid:
    """Extinction and scattering [1/length] at points, in arrays of (bands, z, y, x), and where the points are.

    to_world takes an index (i, j, k, 1) to a place; g is that of Henyey and Greenstein.
    """

    def __init__(self, extinction, scattering, to_world, g):
        self.extinction = numpy.ascontiguousarray(extinction, dtype=float)
        self.scattering = numpy.ascontiguousarray(scattering, dtype=float)
        self.size = numpy.array(self.extinction.shape[:0:-1])
        self.to_index = numpy.linalg.inv(to_world)
        self.g = g

    def index(self, places):
        return places @ self.to_index[:3, :3].T + self.to_index[:3, 3]

    def steps(self, directions):
        return directions @ self.to_index[:3, :3].T

    def read(self, values, index):
        """Values of shape (bands, places); 0 outside of the grid."""
        inside = ((index >= -1e-9) & (index <= self.size - 1 + 1e-9)).all(-1)
        low = numpy.clip(numpy.floor(index).astype(int), 0, self.size - 2)
        part = numpy.clip(index - low, 0.0, 1.0)
        flat = values.reshape(len(values), -1)
        row, slab = self.size[0], self.size[0] * self.size[1]
        first = low[:, 0] + low[:, 1] * row + low[:, 2] * slab
        total = numpy.zeros((len(values), len(index)))
        for corner in range(8):
            i, j, k = corner & 1, corner >> 1 & 1, corner >> 2
            weight = inside.astype(float)
            for axis, high in enumerate((i, j, k)):
                weight *= part[:, axis] if high else 1.0 - part[:, axis]
            total += weight * flat[:, first + i + j * row + k * slab]
        return total

    def cuts(self, start, along, low, high):
        """Where rays cross planes of points, between low and high; those that do not are at low."""
        place, step = self.index(start), self.steps(along)
        found = []
        for axis in range(3):
            with numpy.errstate(divide="ignore", invalid="ignore"):
                at = (numpy.arange(self.size[axis]) - place[:, axis, None]) / step[:, axis, None]
            at = numpy.where(numpy.isfinite(at), at, low[:, None])
            found.append(numpy.clip(at, low[:, None], high[:, None]))
        return numpy.concatenate(found, 1)

    def depth(self, start, along, low, high):
        """Optical depth, of shape (bands, rays), of rays between low and high."""
        place, step = self.index(start), self.steps(along)
        low, high = low.copy(), high.copy()
        for axis in range(3):  # what of them is in the grid
            with numpy.errstate(divide="ignore", invalid="ignore"):
                a = -place[:, axis] / step[:, axis]
                b = (self.size[axis] - 1 - place[:, axis]) / step[:, axis]
            flat = step[:, axis] == 0.0
            inside = (place[:, axis] >= 0.0) & (place[:, axis] <= self.size[axis] - 1)
            a, b = numpy.minimum(a, b), numpy.maximum(a, b)
            low = numpy.where(flat, low, numpy.maximum(low, a))
            high = numpy.where(flat, numpy.where(inside, high, low), numpy.minimum(high, b))
        meet = numpy.flatnonzero(high > low)
        total = numpy.zeros((len(self.extinction), len(start)))
        if len(meet) == 0:
            return total
        ends = numpy.stack([low[meet], high[meet]], 1)
        cuts = numpy.sort(numpy.concatenate(
            [ends, self.cuts(start[meet], along[meet], ends[:, 0], ends[:, 1])], 1), 1)
        ray, piece = numpy.nonzero(numpy.diff(cuts, axis=1) > 0.0)
        begin, end = cuts[ray, piece], cuts[ray, piece + 1]
        which = meet[ray]
        for node in (-1.0 / math.sqrt(3.0), 1.0 / math.sqrt(3.0)):
            at = 0.5 * (begin + end) + 0.5 * node * (end - begin)
            values = self.read(self.extinction, place[which] + at[:, None] * step[which])
            for band, each in enumerate(values):
                total[band] += numpy.bincount(which, 0.5 * (end - begin) * each, len(start))
        return total


class Light:
    """A sun in a direction, of an irradiance; or a lamp at a place, of an intensity, maybe with a cone."""

    def __init__(self, color, direction=None, place=None, axis=None, cone=180.0, exponent=0.0):
        self.color = numpy.array(color, dtype=float)
        self.direction = None if direction is None else numpy.array(direction) / numpy.linalg.norm(direction)
        self.place = None if place is None else numpy.array(place, dtype=float)
        self.axis = None if axis is None else numpy.array(axis) / numpy.linalg.norm(axis)
        self.cosine = math.cos(math.radians(cone))
        self.exponent = exponent

    def look(self, places):
        """The way to it from places, its length, and what would arrive without a medium."""
        if self.place is None:
            return numpy.broadcast_to(self.direction, places.shape), numpy.full(len(places), 1e6), 1.0
        way = self.place - places
        length = numpy.maximum(numpy.linalg.norm(way, axis=-1), TINY)
        way = way / length[:, None]
        strength = 1.0 / length**2
        if self.axis is not None:
            cosine = -way @ self.axis
            strength = numpy.where(cosine >= self.cosine, strength * numpy.maximum(cosine, 0.0)**self.exponent, 0.0)
        return way, length, strength

    def cuts(self, start, along, low, high, count):
        """Where rays are divided: a lamp sees the parts alike, and its cone ends between them."""
        if self.place is None:
            return low[:, None]
        foot = ((self.place - start) * along).sum(-1)
        off = numpy.linalg.norm(start + foot[:, None] * along - self.place, axis=-1)
        off = numpy.maximum(off, 1e-6)
        first, last = numpy.arctan2(low - foot, off), numpy.arctan2(high - foot, off)
        angles = first[:, None] + (last - first)[:, None] * numpy.linspace(0.0, 1.0, count + 1)
        found = [foot[:, None] + off[:, None] * numpy.tan(angles)]
        if self.axis is not None:  # (v.a)^2 = cos^2 v.v of v = start - place + s along
            offset = start - self.place
            square = self.cosine**2
            a = (along @ self.axis)**2 - square
            b = 2.0 * ((along @ self.axis) * (offset @ self.axis) - square * (along * offset).sum(-1))
            c = (offset @ self.axis)**2 - square * (offset * offset).sum(-1)
            with numpy.errstate(divide="ignore", invalid="ignore"):
                root = numpy.sqrt(b * b - 4.0 * a * c)
                both = numpy.stack([(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)], 1)
            found.append(numpy.where(numpy.isfinite(both), both, low[:, None]))
        return numpy.clip(numpy.concatenate(found, 1), low[:, None], high[:, None])


def henyey_greenstein(g, cosine):
    """The phase function of the angle by which light is turned, of an integral of 1 over all directions."""
    return (1.0 - g * g) / (4.0 * math.pi * (1.0 + g * g - 2.0 * g * cosine)**1.5)


class Haze:
    """A homogeneous medium: scattering and absorption [1/length], of red, green and blue, and g."""

    def __init__(self, scattering, absorption, g):
        self.scattering = numpy.array(scattering, dtype=float)
        self.extinction = self.scattering + numpy.array(absorption, dtype=float)
        self.g = g


def integrate(start, along, end, grids, lights, haze=None, points=4, parts=24, shadows=True):
    """Radiance and transmittance, each of shape (rays, 3), of rays that end at a distance.

    points: of the quadrature between two cuts. parts: into how many pieces haze divides a ray, and a lamp. shadows: whether
    media dim the light before it is scattered.
    """
    count = len(start)
    low = numpy.zeros(count)
    cuts = [numpy.stack([low, end], 1)]
    cuts += [grid.cuts(start, along, low, end) for grid in grids]
    cuts += [light.cuts(start, along, low, end, parts) for light in lights]
    if haze:
        cuts.append(end[:, None] * numpy.linspace(0.0, 1.0, parts + 1))
    cuts = numpy.sort(numpy.concatenate(cuts, 1), 1)
    ray, piece = numpy.nonzero(numpy.diff(cuts, axis=1) > 0.0)
    begin, length = cuts[ray, piece], (cuts[ray, piece + 1] - cuts[ray, piece])

    def depth_within(which, first, size):
        """Of pieces that lie in one cell of each grid, (3, pieces)."""
        total = numpy.zeros((3, len(which)))
        for node in (-1.0 / math.sqrt(3.0), 1.0 / math.sqrt(3.0)):
            at = first + 0.5 * (1.0 + node) * size
            places = start[which] + at[:, None] * along[which]
            for grid in grids:
                total += 0.5 * size * grid.read(grid.extinction, grid.index(places))
        return total + (haze.extinction[:, None] * size if haze else 0.0)

    own = depth_within(ray, begin, length)
    sums = numpy.cumsum(own, 1)
    whole = numpy.stack([numpy.bincount(ray, each, count) for each in own])
    before = numpy.concatenate([numpy.zeros((3, 1)), numpy.cumsum(whole, 1)[:, :-1]], 1)  # of earlier rays
    ahead = sums - own - before[:, ray]  # from the eye to each piece

    radiance = numpy.zeros((3, count))
    for node, weight in zip(*numpy.polynomial.legendre.leggauss(points)):
        at = begin + 0.5 * (1.0 + node) * length
        places = start[ray] + at[:, None] * along[ray]
        scattering = [grid.read(grid.scattering, grid.index(places)) for grid in grids]
        some = numpy.flatnonzero(sum(each.max(0) for each in scattering) > 0.0) if not haze else numpy.arange(len(ray))
        seen = numpy.exp(-(ahead[:, some] + depth_within(ray[some], begin[some], (at - begin)[some])))
        places, which = places[some], ray[some]
        for light in lights:
            way, distance, strength = light.look(places)
            cosine = (way * along[which]).sum(-1)
            scattered = numpy.zeros((3, len(some)))
            for grid, each in zip(grids, scattering):
                scattered += henyey_greenstein(grid.g, cosine) * each[:, some]
            if haze:
                scattered += haze.scattering[:, None] * henyey_greenstein(haze.g, cosine)
            lit = numpy.flatnonzero(numpy.broadcast_to(strength, len(some)) > 0.0)
            depth = numpy.zeros((3, len(some)))
            for grid in grids if shadows else ():
                depth[:, lit] += grid.depth(places[lit], way[lit], numpy.zeros(len(lit)), distance[lit])
            if haze and light.place is not None and shadows:
                depth += haze.extinction[:, None] * distance
            arriving = light.color[:, None] * strength * numpy.exp(-depth)
            shining = seen * scattered * arriving * (0.5 * weight * length[some])
            for band in range(3):
                radiance[band] += numpy.bincount(which, shining[band], count)
    return radiance.T, numpy.exp(-whole).T


def view_rays(size, position, focal_point, view_up, angle=None, scale=None):
    """Starts, unit directions, and lengths at depth 1 of the rays of a picture's pixels, rows from the bottom up.

    angle: under which the height is seen [degrees]; or scale: half the height of a parallel projection.
    """
    position = numpy.array(position, dtype=float)
    forward = numpy.array(focal_point) - position
    forward /= numpy.linalg.norm(forward)
    right = numpy.cross(forward, view_up)
    right /= numpy.linalg.norm(right)
    up = numpy.cross(right, forward)
    y, x = numpy.mgrid[0 : size[1], 0 : size[0]]
    half = math.tan(math.radians(0.5 * angle)) if angle else scale
    across = ((2 * x.ravel() + 1 - size[0]) / size[1] * half)[:, None]
    upwards = ((2 * y.ravel() + 1 - size[1]) / size[1] * half)[:, None]
    offset = across * right + upwards * up
    if angle:
        along = forward + offset
        length = numpy.linalg.norm(along, axis=-1)
        return numpy.tile(position, (len(along), 1)), along / length[:, None], length
    return position + offset, numpy.tile(forward, (len(offset), 1)), numpy.ones(len(offset))
