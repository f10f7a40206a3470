# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""A cloud field of a file as extinction [1/m], for clouds.py.

Files are NetCDF of a simulation or reanalysis, or text of SHDOM. beta = 3 w / (2 rho r), where w is the
liquid water content [kg/m^3], r the effective radius of its droplets [m] and rho the density of water: a
droplet is much larger than a wavelength, and takes twice its cross section out of the light [Stephens1978].
"""

import contextlib
import dataclasses
import pathlib
import re

import numpy
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

WATER_DENSITY = 1000.0  # [kg/m^3]
USUAL_RADIUS = 10e-6  # [m], where a file has none
MOST_POINTS = 2**30  # of a field
COVERED = 0.1  # the optical depth from which on a column is a cloud's

# What variables are called, in small letters: the first that a file has is taken.
WATER = ("lwc", "ql", "qc", "clwc", "clw", "qcloud", "qn", "rc", "rl", "cloud_liquid_water_mixing_ratio")
RADIUS = ("reff", "r_eff", "re", "rel", "effective_radius")
AIR = ("rho", "rho0", "rhobar", "dn0", "air_density", "density")

# What units are in SI's; exponents may be written m-3, m^-3, m**-3 or /m3.
OF_VOLUME = {"kgm-3": 1.0, "gm-3": 1e-3}
OF_AIR = {"kgkg-1": 1.0, "1": 1.0, "gkg-1": 1e-3}
OF_RADIUS = {"m": 1.0, **dict.fromkeys(("um", "micron", "microns", "micrometer", "\u00b5m", "\u03bcm"), 1e-6)}
OF_LENGTH = {"m": 1.0, "meter": 1.0, "meters": 1.0, "metre": 1.0, "metres": 1.0, "km": 1000.0}
OF_PRESSURE = {"pa": 1.0, "hpa": 100.0, "mb": 100.0, "mbar": 100.0, "millibar": 100.0, "millibars": 100.0}
METERS_OF_A_DEGREE = 6371e3 * numpy.pi / 180


class FieldError(Exception):
    """A file is not what it should be: the cause, and a remedy."""


@dataclasses.dataclass
class Field:
    """Extinction [1/m] at points [z, y, x] and their coordinates [m], which rise; and what was supposed."""

    extinction: numpy.ndarray
    axes: tuple  # x, y and z
    supposed: list = dataclasses.field(default_factory=list)

    def to_grid(self):
        """A vtkImageData, or a vtkRectilinearGrid if distances of points differ."""
        steps = [numpy.diff(axis) for axis in self.axes]
        if all(numpy.allclose(each, each.mean(), rtol=1e-3) for each in steps):
            grid = vtk.vtkImageData()
            grid.SetSpacing([each.mean() for each in steps])
            grid.SetOrigin([axis[0] for axis in self.axes])
        else:
            grid = vtk.vtkRectilinearGrid()
            for name, axis in zip("XYZ", self.axes):
                getattr(grid, f"Set{name}Coordinates")(numpy_to_vtk(axis, deep=True))
        grid.SetDimensions(self.extinction.shape[::-1])
        scalars = numpy_to_vtk(self.extinction.astype(numpy.float32).ravel(), deep=True)
        scalars.SetName("Extinction_per_m")
        grid.GetPointData().SetScalars(scalars)
        return grid

    def optical_depths(self):
        """Of the columns [y, x], extinction between levels being linear."""
        heights = numpy.diff(self.axes[2])[:, None, None]
        return ((self.extinction[1:] + self.extinction[:-1]) / 2 * heights).sum(0)

    def describe(self):
        depths = self.optical_depths()
        sizes = " x ".join(str(len(axis)) for axis in self.axes)
        spans = " x ".join(f"{(axis[-1] - axis[0]) / 1000:.4g}" for axis in self.axes)
        return (
            f"{sizes} points, {spans} km; extinction up to {self.extinction.max():.4g}/m\n"
            f"optical depth of the columns: {depths.min():.4g} to {depths.max():.4g}, "
            f"{depths.mean():.4g} in the mean\n"
            f"cloud cover: {(depths >= COVERED).mean():.3f} of the columns have {COVERED:g} or more"
        )


def extinction_of(water, radius):
    """[1/m] of water [kg/m^3] in drops of an effective radius [m], which counts where there is water."""
    water = numpy.nan_to_num(numpy.asarray(water, float))
    wet = water > 0  # dynamics leave some that is below, by rounding
    radius = numpy.broadcast_to(radius, water.shape)
    wrong = int((~(radius[wet] > 0)).sum())
    if wrong:
        raise FieldError(f"{wrong} of {wet.sum()} points with water have no effective radius above 0: "
            "give one for all [um], --radius 10")
    result = numpy.zeros(water.shape)
    result[wet] = 3 * water[wet] / (2 * WATER_DENSITY * radius[wet])
    return result


def read(path, variable=None, units=None, radius=None, time=0):
    """The Field of a file, told by its first bytes. Names and units are found if they are customary.

    variable: that of the water; units: of that; radius: the effective one of all drops [m]; time: which step,
    from 0. Raises FieldError.
    """
    path = pathlib.Path(path)
    try:
        with path.open("rb") as file:
            start = file.read(4)
    except OSError as error:
        raise FieldError(f"{path} cannot be read: {error.strerror}. Give NetCDF or a text of SHDOM") from None
    if start[:3] == b"CDF" or start == b"\x89HDF":
        field = _read_netcdf(path, variable, units, radius, time)
    else:
        field = _read_shdom(path, radius)
    if not field.extinction.any():
        raise FieldError(f"{path} has no liquid water: take another --time or --variable")
    return field


def _in(table, units):
    """What a unit is in SI's, or None."""
    plain = re.sub(r"[\s*^.]", "", units)
    plain = re.sub(r"/([a-z]+)(\d*)", lambda found: f"{found[1]}-{found[2] or 1}", plain)
    return table.get(plain, table.get(plain.lower()))


def _standard_height(pressure):
    """[m] of a pressure [Pa] in the standard atmosphere [ICAO1993], to 11 km."""
    return 44330.8 * (1 - (pressure / 101325) ** 0.190263)


def _standard_density(height):
    """[kg/m^3] of air, the same."""
    return 1.225 * (1 - numpy.clip(height, 0, 11000) / 44330.8) ** 4.25588


class _NetCDF:
    """The variables of a file, by VTK's reader of the climate and forecast conventions."""

    def __init__(self, path, time):
        try:
            from vtkmodules.vtkIONetCDF import vtkNetCDFCFReader, vtkNetCDFReader
        except ImportError:
            raise FieldError(f"{path} is NetCDF, and this VTK is built without its module IONetCDF: take "
                "Debian's python3-vtk9, PyPI's vtk, or a text of SHDOM") from None
        self.path, self.time, self.of_grids = path, time, vtkNetCDFCFReader
        reader = self._reader(vtkNetCDFReader)  # which lists coordinates, too
        reader.UpdateMetaData()
        names, dimensions = reader.GetAllVariableArrayNames(), reader.GetVariableDimensions()
        count = names.GetNumberOfValues() if names else 0
        self.dimensions = {names.GetValue(each): dimensions.GetValue(each) for each in range(count)}
        self.units = {}
        for each in set(self.dimensions.values()):
            reader.SetDimensions(each)
            reader.UpdateInformation()
            names = (name for name, of in self.dimensions.items() if of == each)
            self.units.update((name, reader.QueryArrayUnits(name)) for name in names)
        if not self.dimensions:
            raise FieldError(f"{path} has no variables that VTK can read: is it whole, by `ncdump -h`?")

    def _reader(self, kind):
        reader = kind()
        for each in reader, reader.GetExecutive():
            each.AddObserver("ErrorEvent", lambda *_: None)  # the caller finds what is missing, and says so
        reader.SetFileName(str(self.path))
        reader.ReplaceFillValueWithNanOn()
        return reader

    def find(self, names):
        small = {name.lower(): name for name in reversed(self.dimensions)}
        return next((small[name] for name in names if name in small), None)

    def load(self, name):
        """The values of a variable in the file's order, and the grid that has them."""
        reader = self._reader(self.of_grids)
        reader.SphericalCoordinatesOff()
        reader.UpdateMetaData()
        reader.SetDimensions(self.dimensions[name])
        reader.UpdateInformation()
        key = vtk.vtkStreamingDemandDrivenPipeline.TIME_STEPS()
        steps = reader.GetOutputInformation(0).Get(key) or (0.0,)
        if not 0 <= self.time < len(steps) and self.dimensions[name].count(",") > 1:
            raise FieldError(f"{self.path} has {len(steps)} times: --time is from 0 to {len(steps) - 1}")
        reader.UpdateTimeStep(steps[min(self.time, len(steps) - 1)])
        grid = reader.GetOutput()
        for attributes in () if grid is None else (grid.GetPointData(), grid.GetCellData()):
            if attributes.HasArray(name):
                return vtk_to_numpy(attributes.GetArray(name)).astype(float), grid
        raise FieldError(f"VTK cannot read {name}{self.dimensions[name]} of {self.path}: see by `ncdump` "
            "whether it is whole, and has three dimensions, and before them none but a time, in units such "
            "as s since 2000-01-01")


def _read_netcdf(path, variable, units, radius, time):
    file = _NetCDF(path, time)
    known = ", ".join(sorted(each for each, of in file.dimensions.items() if of.count(",") > 1)) or "more"
    name = variable or file.find(WATER)
    if name not in file.dimensions:
        raise FieldError(f"{path} has no variable {variable or 'of a customary name for liquid water'}: "
            f"give one of {known} by --variable")
    values, grid = file.load(name)
    if not isinstance(grid, (vtk.vtkImageData, vtk.vtkRectilinearGrid)):
        raise FieldError(f"{name} of {path} is not on a grid of x, y and z, but on a {grid.GetClassName()}: "
            "interpolate it to one, such as by `cdo remapbil`, with heights or pressures as levels")
    axes = _coordinates(grid)
    shape = tuple(len(axis) for axis in axes[::-1])
    if min(shape) < 2 or values.size != numpy.prod(shape):
        raise FieldError(f"{name} of {path} has {' x '.join(map(str, shape))} levels, rows and columns, "
            "and a cloud field needs 2 of each: take another variable by --variable")
    field = Field(None, None)
    names = [each.strip() for each in file.dimensions[name].strip("()").split(",")][-3:]
    axes = _in_meters(file, axes, names, field.supposed)
    water = values.reshape(shape)
    if numpy.isnan(water).all():
        raise FieldError(f"{name} of {path} is missing everywhere at this time: take another one by --time")

    units = units or file.units[name]
    if _in(OF_VOLUME, units) is not None:
        water = water * _in(OF_VOLUME, units)
    elif _in(OF_AIR, units) is not None:
        air = file.find(AIR)
        if air is not None and _in(OF_VOLUME, file.units[air]) is not None:
            density = _spread(file.load(air)[0] * _in(OF_VOLUME, file.units[air]), shape, air, path)
        else:
            density = _standard_density(axes[2])[:, None, None]
            field.supposed.append("air is as dense as the standard atmosphere's")
        water = water * _in(OF_AIR, units) * density
    else:
        raise FieldError(f"{name} of {path} is in '{units}', which is no content of water: give what "
            "it is in by --units, kg/m3, g/m3, kg/kg or g/kg")

    source = file.find(RADIUS)
    if radius is None and source is not None:
        factor = _in(OF_RADIUS, file.units[source])
        if factor is None:
            raise FieldError(f"{source} of {path} is in '{file.units[source]}', not in m or um: give the "
                "radius of all drops [um], --radius 10")
        radius = _spread(file.load(source)[0] * factor, shape, source, path)
    elif radius is None:
        radius = USUAL_RADIUS
        field.supposed.append(f"drops have an effective radius of {USUAL_RADIUS * 1e6:g} um")
    extinction = extinction_of(water, radius)

    falling = [axis[0] > axis[-1] for axis in axes]  # from north to south, or from above
    field.axes = tuple(axis[::-1] if falls else axis for axis, falls in zip(axes, falling))
    field.extinction = extinction[tuple(slice(None, None, -1 if falls else 1) for falls in falling[::-1])]
    for label, axis in zip(names[::-1], field.axes):
        if not (numpy.diff(axis) > 0).all():
            raise FieldError(f"the coordinate {label} of {path} neither rises nor falls all the way: sort it")
    return field


def _coordinates(grid):
    """x, y and z of a grid as arrays."""
    if isinstance(grid, vtk.vtkRectilinearGrid):
        return [vtk_to_numpy(getattr(grid, f"Get{name}Coordinates")()).astype(float) for name in "XYZ"]
    places = zip(grid.GetOrigin(), grid.GetSpacing(), grid.GetExtent()[::2], grid.GetDimensions())
    return [origin + spacing * numpy.arange(first, first + count) for origin, spacing, first, count in places]


def _in_meters(file, axes, names, supposed):
    """Coordinates x, y and z of dimensions z, y and x, which may be degrees and pressures."""
    latitudes = file.units.get(names[1], "").startswith("degree")
    shrink = numpy.cos(numpy.deg2rad(axes[1].mean())) if latitudes else 1.0
    result = []
    for index, (axis, name) in enumerate(zip(axes, names[::-1])):
        units = file.units.get(name, "")
        if units.startswith("degree") and index < 2:
            degree = METERS_OF_A_DEGREE * (1.0 if index else shrink)
            axis = (axis - axis.mean()) * degree
            supposed.append(f"a degree of {name} is {degree / 1000:.4g} km")
        elif index == 2 and _in(OF_PRESSURE, units) is not None:
            axis = _standard_height(axis * _in(OF_PRESSURE, units))
            supposed.append(f"{name} is as high as in the standard atmosphere")
        elif _in(OF_LENGTH, units) is not None:
            axis = axis * _in(OF_LENGTH, units)
        elif not units:
            supposed.append(f"{name} is in m")
        else:
            raise FieldError(f"the coordinate {name} of {file.path} is in '{units}': convert it to m or km, "
                f"{'hPa or Pa' if index == 2 else 'or degrees'}, such as by `ncap2`")
        result.append(axis)
    return result


def _spread(values, shape, name, path):
    """Values of a whole grid, or of its levels, for each point."""
    if values.size == numpy.prod(shape):
        return values.reshape(shape)
    if values.size == shape[0]:
        return values[:, None, None]
    raise FieldError(f"{name} of {path} has {values.size} values, neither one for each point nor for each "
        "level: rename it")


def _read_shdom(path, radius):
    """nx ny nz; dx dy [km]; heights [km]; then i j k, water [g/m^3] and effective radius [um] of wet points.

    SHDOM's own has the format's number 2 before and temperatures after the heights, and counts from 1;
    pyshdom counts from 0, and may have the heights beside dx dy. Commas may be between numbers; what is
    after # or has a word in it is a comment.
    """
    rows = []
    try:
        for line in path.read_text(encoding="utf-8").splitlines():
            with contextlib.suppress(ValueError):
                rows.append([float(word) for word in line.split("#")[0].replace(",", " ").split()])
    except UnicodeDecodeError:
        raise FieldError(f"{path} is neither NetCDF nor text: give a file of one of both") from None
    rows = [row for row in rows if row]
    of_shdom = bool(rows) and rows[0] == [2.0]
    rows = rows[of_shdom:]
    if len(rows) > 1 and len(rows[0]) == 3 and len(rows[1]) == 2 + rows[0][2]:
        rows[1:2] = rows[1][:2], rows[1][2:]
    if len(rows) < 4 or len(rows[0]) != 3 or len(rows[1]) != 2:
        raise FieldError(f"{path} is neither NetCDF nor a cloud of SHDOM, whose text begins with lines "
            "of nx ny nz, dx dy, and nz heights: see Examples/Science/README.md")
    steps, heights, points = rows[1], numpy.array(rows[2]), rows[4 if of_shdom else 3 :]
    counts = numpy.array(rows[0])
    if not (counts >= 2).all() or not counts.prod() <= MOST_POINTS or not min(steps) > 0:
        raise FieldError(f"{path} begins with {rows[0]} and {steps}: nx ny nz must be 2 or more each, "
            f"{MOST_POINTS} in all at most, and dx dy above 0")
    counts = counts.astype(int)
    if len(heights) != counts[2] or not (numpy.diff(heights) > 0).all():
        raise FieldError(f"the heights of {path} must be {counts[2]} and rise")
    if not points or min(map(len, points)) < 5:
        raise FieldError(f"a line of {path} has fewer than five numbers: i j k, "
            "water [g/m^3], effective radius [um]")
    points = numpy.array([row[:5] for row in points])
    counted_from = int(of_shdom or points[:, :3].min() >= 1 and (points[:, :3].max(0) == counts).any())
    places = points[:, :3] - counted_from
    if not ((places >= 0) & (places < counts)).all():
        raise FieldError(f"{path} has points outside of its {' x '.join(map(str, counts))}: correct these")
    places = tuple(places.astype(int).T[::-1])
    water, drops = numpy.zeros(counts[::-1]), numpy.full(counts[::-1], numpy.nan)
    water[places], drops[places] = points[:, 3] * 1e-3, points[:, 4] * 1e-6
    axes = *(1000 * step * numpy.arange(count) for step, count in zip(steps, counts)), 1000 * heights
    extinction = extinction_of(water, drops if radius is None else radius)
    return Field(extinction, axes, [f"points count from {counted_from}"])


def _turbulence(random, shape):
    """Periodic noise of turbulence's spectrum, a power of -11/3 in three dimensions, whose deviation is 1."""
    waves = numpy.fft.rfftn(random.normal(size=shape))
    k = numpy.sqrt(sum(each**2 for each in numpy.ix_(
        *(numpy.fft.fftfreq(count) for count in shape[:-1]), numpy.fft.rfftfreq(shape[-1]))))
    noise = numpy.fft.irfftn(waves * numpy.maximum(k, 1 / 24) ** (-11 / 6), shape, (0, 1, 2))
    return numpy.clip(noise / noise.std(), -2, 2)


def make(step=40.0, seed=4):
    """A field that is made up, not simulated: cumuli as heaps of bubbles over one base, in 7 x 7 x 2.4 km.

    Water grows with the height over the base by 1 g/m^3 each km, half of what a cloud has that keeps all of
    it; 80 drops are in a cm^3. step: of points [m].
    """
    random = numpy.random.default_rng(seed)
    x, y, z = (numpy.arange(low, high + step, step) for low, high in ((-3500, 3500), (0, 7000), (700, 3100)))
    base = 900.0
    inside = numpy.full((len(z), len(y), len(x)), -1.0)  # above 0 in a bubble, 1 at its centre
    for _ in range(30):
        heart = random.uniform((-3200, 300), (3200, 6700))
        size = min(160 + 220 * random.pareto(2.2), 700)
        for _ in range(int(60 + size / 3)):
            height = random.uniform(0, 1) ** 1.3
            around = numpy.clip(random.normal(size=2), -1.6, 1.6) * size * 0.62 * (1 - 0.75 * height)
            radius = size * min(0.1 + 0.07 * random.pareto(2), 0.4) * (1 - 0.35 * height)
            place = (*(heart + around), base + height * size * 1.9)
            cut = tuple(slice(*numpy.searchsorted(axis, (at - 1.5 * radius, at + 1.5 * radius)))
                for axis, at in zip((z, y, x), place[::-1]))
            away = [axis[part] - at for axis, part, at in zip((z, y, x), cut, place[::-1])]
            squares = away[0][:, None, None] ** 2 + away[1][:, None] ** 2 + away[2] ** 2
            inside[cut] = numpy.maximum(inside[cut], 1 - numpy.sqrt(squares) / radius)
    inside += 0.22 * _turbulence(random, inside.shape)
    above = numpy.clip(z - base, 0, None)[:, None, None]
    water = 0.5 * 2e-6 * (above + 60) * (above > 0) * numpy.clip(inside / 0.25, 0, 1)
    of_volume = (3 * numpy.maximum(water, 1e-12) / (4 * numpy.pi * WATER_DENSITY * 80e6)) ** (1 / 3)
    radius = of_volume / 0.8 ** (1 / 3)  # drops of several sizes
    return Field(extinction_of(water, radius), (x, y, z), ["the field is made up"])
