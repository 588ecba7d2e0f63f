"""How benchmarks become Markdown tables."""

import re

# Headings, and which families of benchmarks go where, with what they measure. Families that are not
# listed come last, under their names.
SECTIONS = [
    ("Limits of the machine", [
        ("limit_.*", "One thread, compiled as everything else."),
        ("memory_bandwidth", "Reading, on several threads."),
        ("kernel", "The time of each kernel."),
    ]),
    ("The whole job", [
        ("whole_job_by_edge_length", "From a file to a mesh in memory, with an edge length."),
        ("whole_job_by_count", "The same with a number of triangles, for which an edge length is "
                               "searched."),
        ("many_models", "From loops to meshes of 10,000 triangles, each on one thread."),
        ("tessellate_by_edge_length", "From a patch to a mesh with normals, on one thread, and "
                                      "where the time goes."),
        ("tessellate_domain_mesh", "Evaluation and assembly alone."),
    ]),
    ("Ribbons and domains", [
        ("ribbons_.*", ""),
        ("domain_.*", ""),
        ("patch_of_model", "From a loop to a patch that can be evaluated."),
        ("patch_of_dome", "The same over the number of sides, degree and layers."),
    ]),
    ("Coordinates", [
        ("harmonic_scaling", "Setting up harmonic coordinates over the number of sides."),
        ("coordinates_of_points", "Points with gradients, one by one."),
        ("harmonic_single", "100,000 points one by one; the number is the order of derivatives."),
        ("harmonic_batch", "The same at once."),
    ]),
    ("Basis and patch", [
        ("basis_combination", "From coordinates to points, one by one; the number is the order of "
                              "derivatives."),
        ("patch_point", "Points of patches, one by one; the number is the order of derivatives."),
        ("points_one_by_one", "Points with normals, one by one."),
        ("points_at_once", "The same at once."),
        ("points_of_model_at_once", "The same for models."),
    ]),
    ("Evaluation after a change of the net", [
        ("all_control_points_move", "The points of fixed samples anew, after all control points "
                                    "moved; the number is the order of derivatives."),
        ("one_control_point_moves", "After one of them moved."),
        ("one_ribbon_moves", "After one ribbon moved."),
    ]),
    ("Meshing of domains", [
        ("mesh_evenly", "Evenly, on one thread; the last row of a domain is smoothed."),
        ("mesh_by_count", "For a number of triangles on the surface."),
        ("mesh_by_deviation", "For a chordal deviation: a part of the loop's diagonal."),
    ]),
    ("Analysis", [("analysis_.*", "")]),
    ("Peers", [
        ("peer_harmonic_.*", "Harmonic coordinates: from a polygon to values at the same points."),
        ("peer_mesher_.*", "Meshing: as many triangles in the same domain."),
        ("peer_filling", "Filling a hole: time, and how far the tangent planes along the boundary "
                         "are from those of the ribbons."),
    ]),
]

# Arguments that are numbers of something the label names.
INDICES = {"model", "plan", "domain", "kernel", "method"}
# What Google Benchmark says of every case.
COMMON = {"name", "family_index", "per_family_instance_index", "run_name", "run_type", "repetitions",
          "repetition_index", "threads", "iterations", "real_time", "cpu_time", "time_unit", "label",
          "error_occurred", "error_message", "aggregate_name", "aggregate_unit"}
UNITS = {"s/": "s", "per_point": "s", "bytes/s": "B/s", "bytes_per_second": "B/s",
         "bandwidth": "B/s", "flops/s": "flop/s"}


def markdown_table(header, rows):
    lines = ["| " + " | ".join(str(cell).replace("|", "\\|") for cell in row) + " |"
             for row in [header, ["---"] * len(header), *rows]]
    return "\n".join(lines) + "\n"


def quantity(value, unit):
    """three digits with a prefix: 1.23e-5 s is 12.3 µs"""
    if value == 0:
        return f"0 {unit}"
    for prefix, scale in (("T", 1e12), ("G", 1e9), ("M", 1e6), ("k", 1e3), ("", 1), ("m", 1e-3),
                          ("µ", 1e-6), ("n", 1e-9), ("p", 1e-12)):
        # Whole and thousands of seconds are just that.
        if abs(value) >= 0.9995 * scale and not (unit == "s" and scale > 1):
            break
    digits = f"{value / scale:#.3g}".rstrip(".") if abs(value / scale) < 999.5 else \
        f"{value / scale:.0f}"
    return f"{digits} {prefix}{unit}"


def number(name, value):
    for prefix, unit in UNITS.items():
        if name.startswith(prefix):
            return quantity(value, unit)
    if value == int(value) and abs(value) < 1e15:
        return f"{int(value):,}"
    return f"{value:.1e}" if abs(value) < 1e-3 else f"{value:#.3g}".rstrip(".")


class Case:
    """One benchmark: its arguments and what was measured, as text by column.

    limits(threads) are the largest rates of the machine, by the names of rates. A benchmark may
    have measured its own `bandwidth`.
    """

    def __init__(self, benchmark, limits):
        self.name, *parts = re.split(r"/(?![^<]*>)", benchmark["name"])
        threads = re.search(r"/threads:(\d+)", benchmark["name"])
        self.limits = limits(int(threads.group(1)) if threads else 1)
        if "bandwidth" in benchmark:
            self.limits = {**self.limits, "bytes/s": benchmark["bandwidth"]}
        label = benchmark.get("label", "")
        # Angle brackets would be HTML.
        name = self.name.replace("_", " ").replace("<", ", ").replace(">", "")
        self.arguments = {"case": name + (f": {label}" if label else "")}
        self.measured = {}
        for k, part in enumerate(p for p in parts if is_argument(p)):
            key, _, value = part.rpartition(":")
            if not (label and key in INDICES):
                self.arguments[key or f"argument {k + 1}"] = f"{int(value):,}"
        if benchmark.get("error_occurred"):
            self.measured["time"] = benchmark["error_message"]
            return
        real = "real_time" in parts or "manual_time" in parts
        scale = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1}[benchmark["time_unit"]]
        self.measured["time"] = quantity(benchmark["real_time" if real else "cpu_time"] * scale, "s")
        if "process_time" in parts:
            self.measured["CPU time"] = quantity(benchmark["cpu_time"] * scale, "s")
        for key, value in benchmark.items():
            if key not in COMMON and isinstance(value, (int, float)):
                self.add(key, value)

    def add(self, key, value):
        self.measured[key.replace("_", " ")] = number(key, value)
        rate = "bytes/s" if key == "bytes_per_second" else key
        if self.limits.get(rate) and not re.match("limit_|memory_bandwidth", self.name):
            what = "bandwidth" if rate == "bytes/s" else "flop limit"
            self.measured[f"of the {what}"] = f"{100 * value / self.limits[rate]:.1f} %"


def is_argument(part):
    """whether a part of a benchmark's name is an argument, and no setting of Google Benchmark"""
    return re.match(r"(\w+:)?-?\d+$", part) and \
        not re.match(r"(iterations|repeats|min_time|min_warmup_time):", part)


def family_table(title, benchmarks, limits):
    cases = [Case(b, limits) for b in benchmarks]

    def columns(cells):
        return list(dict.fromkeys(c for case in cases for c in cells(case)))

    arguments, measured = columns(lambda c: c.arguments), columns(lambda c: c.measured)
    rows = [[case.arguments.get(c, "") for c in arguments] +
            [case.measured.get(c, "") for c in measured] for case in cases]
    return (title + "\n\n" if title else "") + markdown_table(arguments + measured, rows)
