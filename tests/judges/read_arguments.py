"""What the headers of emitted C say of the functions."""

import re


def read_arguments(header, prefix, real):
    """Names and arguments in order: results are those that are not const. Shapes are in the comments."""
    declarations = re.finditer(rf"((?:^///[^\n]*\n)+)^(?:void|{real}) {prefix}_(\w+)\((.*?)\);", header, re.M | re.S)
    for comment, name, parameters in (match.groups() for match in declarations):
        shapes = dict(re.findall(r"^/// (?:in|out)\s+(\w+) \(([\dx]+)\):", comment, re.M))
        arguments = []
        array = rf"(const )?{real} (\w+)\[TREELINE_{prefix.upper()}_ARRAY\((\d+)\)\]"
        for constant, symbol, size in re.findall(array, parameters):
            shape = tuple(int(n) for n in shapes.get(symbol, size).split("x"))
            arguments.append((symbol, shape, not constant))
        yield name, arguments
