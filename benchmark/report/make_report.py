#!/usr/bin/env python3
"""Makes one JSON file and Markdown tables of what a run of the benchmarks wrote.

Usage: make_report.py [options] --json OUT.json --markdown OUT.md BENCHMARKS.json...
"""

import argparse
import json
import os
import platform
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from tables import SECTIONS, family_table, markdown_table, quantity  # noqa: E402

BEGIN, END = "<!-- begin of the tables -->", "<!-- end of the tables -->"
# Quoted, not measured: what the reference implementation of the patch takes for the whole job.
REFERENCE_SECONDS = 0.33


class Results:
    """What a run measured, by name."""

    def __init__(self, files, kernels, recorded):
        self.context, self.benchmarks = {}, []
        for name in files:
            with open(name, encoding="utf-8") as file:
                content = json.load(file)
            self.context = {**content["context"], **self.context}
            self.benchmarks += content["benchmarks"]
        self.kernels, self.recorded = kernels, recorded

    def family(self, name):
        return [b for b in self.benchmarks if re.match(rf"{name}\b", b["name"])]

    def find(self, pattern):
        """the first benchmark whose name matches, if there is one without an error"""
        for benchmark in self.benchmarks:
            if re.match(pattern, benchmark["name"]) and not benchmark.get("error_occurred"):
                return benchmark
        return None

    def limits(self, threads=1):
        """the largest rates that were measured of bytes and operations, if any were"""
        cases = self.family(f"memory_bandwidth/threads:{threads}")
        if threads == 1:
            cases += self.family("limit_.*")
        return {rate: max((b[rate] for b in cases if rate in b), default=None)
                for rate in ("bytes/s", "flops/s")}


def seconds(benchmark):
    scale = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1}[benchmark["time_unit"]]
    return benchmark["real_time"] * scale


# --------------------------------------------------------------------------------------- sections

def machine(results, options):
    def first_line(file, pattern):
        try:
            with open(file, encoding="utf-8") as text:
                match = re.search(pattern, text.read(), re.MULTILINE)
            return match.group(1) if match else "unknown"
        except OSError:
            return "unknown"

    context = results.context
    caches = ", ".join(f"L{c['level']} {c['type'].lower()} {c['size'] // 1024} KiB"
                       for c in context.get("caches", []))
    memory = first_line("/proc/meminfo", r"^MemTotal:\s*(\d+)")
    rows = [
        ["processor", first_line("/proc/cpuinfo", r"^model name\s*: (.*)$") +
         f", {context['num_cpus']} cores at {context['mhz_per_cpu']} MHz"],
        ["caches", caches],
        ["memory", f"{int(memory) / 2**20:.0f} GiB" if memory.isdigit() else memory],
        ["system", f"{platform.system()}, " +
         first_line("/etc/os-release", r'^PRETTY_NAME="(.*)"')],
        ["compiler", f"{context.get('compiler', 'unknown')}, {options.build}"],
        ["libraries", f"CGAL {context.get('CGAL')}, Eigen {context.get('Eigen')}"],
        ["run", context["date"][:10] + (", quick: fewer and smaller cases" if options.quick else "")],
    ]
    return "### Machine\n\n" + markdown_table(["", ""], rows)


def summary(results):
    """The few numbers that the project wants to be good at."""
    rows = []

    def add(what, value, remark=""):
        rows.append([what, value, remark])

    for threads in (1, 2):
        job = results.find(rf"whole_job_by_edge_length/model:2/vertices:50000/threads:{threads}\b")
        if job:
            add(f"whole job, 50,000 vertices, {threads} thread{'s' if threads > 1 else ''}",
                quantity(seconds(job), "s"),
                f"{REFERENCE_SECONDS / seconds(job):.1f} times as fast as the {REFERENCE_SECONDS} s "
                "quoted (not measured here) for the reference implementation")
    for triangles in (100000, 1000000):
        cases = [b for b in results.family("mesh_evenly")
                 if f"triangles:{triangles}/sweeps:0" in b["name"] and "s/triangle" in b]
        if cases:
            add(f"meshing a domain with {triangles:,} triangles, each",
                ", ".join(quantity(b["s/triangle"], "s") for b in cases),
                "; ".join(f"{b['label']}: smallest angle {b['smallest_angle']:.1f}°" for b in cases))
    patch = results.find(r"patch_of_model/model:2/threads:1\b")
    if patch:
        add("from a loop with 8 sides to a patch, 1 thread", quantity(seconds(patch), "s"))
    points = results.find(r"points_of_model_at_once/model:2/points:50000/threads:1\b")
    if points:
        add("points with normals of it, at once, each, 1 thread", quantity(points["s/point"], "s"))
    for threads in (1, 2):
        for size in (1000000, 100000):
            case = results.find(
                rf"all_control_points_move<1, double>/points:{size}/threads:{threads}\b")
            if case and "bandwidth" in case:
                add(f"{size:,} points and normals anew, all control points having moved, {threads} "
                    f"thread{'s' if threads > 1 else ''}", quantity(seconds(case), "s"),
                    f"{100 * case['bytes/s'] / case['bandwidth']:.0f} % of the memory bandwidth")
                break
    move = results.find(r"one_control_point_moves<1, double>/points:100000/threads:1\b")
    if move:
        add("100,000 points and normals anew, one control point having moved, 1 thread",
            quantity(seconds(move), "s"))
    one, two = (results.find(rf"many_models/models:1000/threads:{t}\b") for t in (1, 2))
    for benchmark, threads in ((one, 1), (two, 2)):
        if benchmark:
            gain = f"{seconds(one) / seconds(two):.2f} times as fast" if one and threads == 2 else ""
            add(f"1,000 random models, {threads} thread{'s' if threads > 1 else ''}",
                f"{benchmark['models/s']:.1f} models/s", gain)
    return "### In short\n\n" + markdown_table(["what", "measured", ""], rows) if rows else ""


def change(now, before):
    return f"{round(100 * (now / before - 1), 1) + 0.0:+} %"


def kernel_table(results):
    if not results.kernels:
        return ""
    limits = results.limits()
    rows = []
    for name, counts in results.kernels.items():
        items, timing = counts["items"], next(
            (b for b in results.family("kernel") if b.get("label") == name), None)
        time = timing["s/item"] if timing else None
        recorded = results.recorded.get(name)

        def share(amount, rate):
            return (f"{100 * amount / items / time / limits[rate]:.1f} %"
                    if time and limits[rate] else "")

        rows.append([
            name.replace("_", " "), quantity(time, "s") if time else "",
            f"{counts['instructions'] / items:,.1f}",
            change(counts["instructions"] / items, recorded) if recorded else "",
            f"{counts['flops'] / items:,.1f}", share(counts["flops"], "flops/s"),
            f"{(counts['loads'] + counts['stores']) / items:,.1f}",
            f"{counts['bytes_beyond_cache'] / items:,.1f}",
            share(counts["bytes_beyond_cache"], "bytes/s"),
            f"{counts['instructions'] / items / time * 1e-9:.2f}" if time else "",
        ])
    return "What the kernels execute, for each point or triangle.\n\n" + markdown_table(
        ["kernel", "time", "instructions", "since recorded", "flops",
         "of the flop limit", "loads and stores", "bytes beyond the cache", "of the bandwidth",
         "instructions/ns"], rows)


def all_tables(results, options):
    parts = [machine(results, options), summary(results)]
    rest = [b for b in results.benchmarks if b.get("run_type") != "aggregate"]
    for heading, families in SECTIONS:
        tables = []
        for family, title in families:
            members = [b for b in rest if re.match(rf"{family}(/|<|$)", b["name"])]
            rest = [b for b in rest if b not in members]
            if members and not (family == "kernel" and results.kernels):  # which has them
                tables.append(family_table(title, members, results.limits))
        if heading == "Limits of the machine":
            tables.append(kernel_table(results))
        if any(tables):
            parts.append(f"### {heading}\n\n" + "\n".join(filter(None, tables)))
    for family in dict.fromkeys(re.split("[/<]", b["name"])[0] for b in rest):
        members = [b for b in rest if re.split("[/<]", b["name"])[0] == family]
        parts.append(f"### {family.replace('_', ' ').capitalize()}\n\n" +
                     family_table("", members, results.limits))
    return "\n".join(filter(None, parts))


# ----------------------------------------------------------------------------------------- output

def write(name, text):
    with open(name + ".new", "w", encoding="utf-8") as file:
        file.write(text)
    os.replace(name + ".new", name)


def update_document(name, tables):
    with open(name, encoding="utf-8") as file:
        text = file.read()
    if text.count(BEGIN) != 1 or text.count(END) != 1:
        sys.exit(f"{name}: expected one '{BEGIN}' and one '{END}'")
    before, after = text.split(BEGIN)[0], text.split(END)[1]
    write(name, f"{before}{BEGIN}\n\n{tables}\n{END}{after}")


def load(name):
    if name and os.path.exists(name):
        with open(name, encoding="utf-8") as file:
            return json.load(file)
    return {}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("benchmarks", nargs="+", help="output of Google Benchmark")
    parser.add_argument("--kernels", help="output of count_kernels.py")
    parser.add_argument("--recorded", help="instructions an item, as recorded; for comparison")
    parser.add_argument("--record", action="store_true", help="and write this run's to that file")
    parser.add_argument("--json", required=True)
    parser.add_argument("--markdown", required=True)
    parser.add_argument("--document", help="a file whose tables are replaced")
    parser.add_argument("--build", default="Release", help="how it was compiled")
    parser.add_argument("--quick", action="store_true", help="say that the run was a quick one")
    options = parser.parse_args()

    results = Results(options.benchmarks, load(options.kernels), load(options.recorded))
    tables = all_tables(results, options)
    write(options.json, json.dumps({"context": results.context, "benchmarks": results.benchmarks,
                                    "kernels": results.kernels}, indent=1) + "\n")
    write(options.markdown, "# Benchmarks\n\n" + tables)
    if options.document:
        update_document(options.document, tables)
    if options.record and results.kernels:
        write(options.recorded,
              json.dumps({name: round(counts["instructions"] / counts["items"], 2)
                          for name, counts in results.kernels.items()}, indent=2) + "\n")


if __name__ == "__main__":
    main()
