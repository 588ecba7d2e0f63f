#!/usr/bin/env python3
"""Counts what the kernels of count_kernels.cpp execute, by callgrind, and writes it as JSON.

Usage: count_kernels.py PROGRAM OUTPUT.json

For each kernel: instructions; floating-point operations, which follow from how often each
instruction was executed and from what the disassembler says it is; loads and stores; and cache lines
from beyond a simulated last cache of 8 MiB.
"""

import collections
import json
import re
import subprocess
import sys
import tempfile

EVENTS = ["Ir", "Dr", "Dw", "DLmr", "DLmw"]
CACHES = ["--I1=32768,8,64", "--D1=32768,8,64", "--LL=8388608,16,64"]  # the same on all machines
CACHE_LINE = 64  # bytes

# SSE and AVX arithmetic; comparisons, conversions and moves are no floating-point operations.
ARITHMETIC = re.compile(r"v?(add|sub|mul|div|sqrt|addsub|hadd|hsub)(s|p)(s|d)$")
FUSED = re.compile(r"vf(n?m)(add|sub|addsub|subadd)(132|213|231)(s|p)(s|d)$")
X87 = re.compile(r"f(add|sub|mul|div|subr|divr|sqrt)p?[sl]?$")


def operations(mnemonic, operands):
    """the floating-point operations of one execution of an x86 instruction"""
    match = ARITHMETIC.match(mnemonic) or FUSED.match(mnemonic)
    if match is None:
        return 1 if X87.match(mnemonic) else 0
    packed, precision = match.groups()[-2:]
    register = 64 if "%zmm" in operands else 32 if "%ymm" in operands else 16
    lanes = register // (8 if precision == "d" else 4) if packed == "p" else 1
    return lanes * (2 if mnemonic.startswith("vf") else 1)


def run_callgrind(program, kernel):
    """the items of a kernel, and the output of callgrind"""
    with tempfile.NamedTemporaryFile(mode="r") as output:
        run = subprocess.run(
            ["valgrind", "--tool=callgrind", "--collect-atstart=no",
             "--toggle-collect=measured_kernel", "--dump-instr=yes", "--cache-sim=yes", *CACHES,
             "--compress-pos=no", "--compress-strings=no",
             f"--callgrind-out-file={output.name}", program, kernel],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
        if run.returncode != 0:
            sys.exit(f"callgrind failed on {kernel}:\n{run.stderr}")
        return int(run.stdout), output.read().splitlines()


def parse(lines):
    """the sum of each event, and how often the instruction at each (object, address) was executed"""
    columns, sums, executions = [], collections.Counter(), collections.Counter()
    binary, is_call = "", False
    for line in lines:
        if line.startswith("events:"):
            columns = line.split()[1:]
        elif line.startswith("ob="):
            binary = line[3:]
        elif line.startswith("calls="):
            is_call = True  # the next line is what was spent in the callee, which counts there
        elif re.match(r"0x[0-9a-f]+ ", line):
            address, _, *costs = line.split()
            if not is_call:
                for event, cost in zip(columns, costs):
                    sums[event] += int(cost)
                executions[binary, int(address, 16)] += int(costs[0])
            is_call = False
    return sums, executions


def disassemble(binary):
    """mnemonic and operands by address"""
    listing = subprocess.run(["objdump", "-d", "--no-show-raw-insn", binary],
                             stdout=subprocess.PIPE, text=True, check=True).stdout
    return {int(address, 16): (mnemonic, operands) for address, mnemonic, operands in
            re.findall(r"^ *([0-9a-f]+):\t(\S+)(.*)$", listing, re.MULTILINE)}


def count_operations(executions):
    instructions = {binary: disassemble(binary) for binary in {b for b, _ in executions}
                    if binary.startswith("/")}
    total = unknown = 0
    for (binary, address), count in executions.items():
        instruction = instructions.get(binary, {}).get(address)
        if instruction is None:
            unknown += count
        else:
            total += count * operations(*instruction)
    return total, unknown


def count(program, kernel):
    items, lines = run_callgrind(program, kernel)
    sums, executions = parse(lines)
    flops, unknown = count_operations(executions)
    if unknown > 0.01 * sums["Ir"]:
        sys.exit(f"{kernel}: {unknown} of {sums['Ir']} instructions are not in the disassembly")
    return {
        "items": items,
        "instructions": sums["Ir"],
        "flops": flops,
        "loads": sums["Dr"],
        "stores": sums["Dw"],
        "bytes_beyond_cache": CACHE_LINE * (sums["DLmr"] + sums["DLmw"]),
    }


def main():
    program, output = sys.argv[1:]
    names = subprocess.run([program], stdout=subprocess.PIPE, text=True, check=True).stdout.split()
    kernels = {}
    for name in names:
        kernels[name] = count(program, name)
        print(f"  {name}: {kernels[name]['instructions'] / kernels[name]['items']:.1f} "
              "instructions an item", flush=True)
    with open(output, "w", encoding="utf-8") as file:
        json.dump(kernels, file, indent=2)


if __name__ == "__main__":
    main()
