#!/usr/bin/env python3
"""Puts code that CppADCodeGen recorded of Pinocchio into a copy of a generated folder.

    use_recorded.py RECORDED GENERATED OUTPUT

RECORDED is what treeline_bench_cppadcodegen_record wrote, GENERATED a folder of inverse_dynamics,
mass_matrix and forward_dynamics. `treeline check --target NAME --generated OUTPUT` then compiles,
runs and counts the recorded statements like generated ones; it says that their bits differ. Sines
and cosines are those of the generated folder, each computed once, which makes them cheaper than
those of a library. Where the folder is in float, so are numbers and variables.
"""
import pathlib
import re
import shutil
import sys

INPUTS = {
    'inverse_dynamics': (('q', 'qd', 'qdd'), 'tau'),
    'mass_matrix': (('q',), 'M'),
    'forward_dynamics': (('q', 'qd', 'tau'), 'qdd'),
}
NUMBER = re.compile(r'(?<![\w.\[])(?:\d+\.\d*(?:e[+-]?\d+)?|\d+e[+-]?\d+|\d+)(?![\w.\]])')


def in_float(statements):
    """The statements with numbers and variables of type float."""
    def literal(match):
        number = match.group(0)
        return number + ('f' if '.' in number or 'e' in number else '.0f')
    return NUMBER.sub(literal, statements.replace('double', 'float'))


def statements_of(recorded, name):
    """What the recorded function does, with arguments named as the generated one's."""
    text = (recorded / f'{name}.cpp').read_text()
    body = text[text.index('noexcept {') + len('noexcept {'):text.rindex('}\n\n}')]
    body = re.sub(r'  const double\* __restrict in\d = in\[\d\];\n', '', body)
    body = re.sub(r'\b(sin|cos)\(in0\[(\d+)\]\)', r'\1_of_[\2]', body)
    if re.search(r'\b(sin|cos)\(', body):
        sys.exit(f'{name}: a sine of something else than a joint angle')
    inputs, output = INPUTS[name]
    for i, argument in enumerate(inputs):
        body = body.replace(f'in{i}[', f'{argument}[')
    return body.replace('y[', f'{output}[')


def print_sines(body):
    """Sines and cosines of the angles that the statements use."""
    angles = sorted({int(i) for i in re.findall(r'(?:sin|cos)_of_\[(\d+)\]', body)})
    count, most = len(angles), angles[-1] + 1
    lines = [f'  const Real angles_[{count}] = {{{", ".join(f"q[{i}]" for i in angles)}}};',
             f'  Real sines_[{count}], cosines_[{count}], sin_of_[{most}], cos_of_[{most}];',
             '  detail::sin_cos(angles_, sines_, cosines_);']
    lines += [f'  sin_of_[{angle}] = sines_[{i}];\n  cos_of_[{angle}] = cosines_[{i}];'
              for i, angle in enumerate(angles)]
    return '\n' + '\n'.join(lines)


def main(recorded, generated, output):
    shutil.copytree(generated, output)
    header = next(output.glob('*_calls.hpp')).name.removesuffix('_calls.hpp') + '.hpp'
    single = 'using Real = float' in (generated / header).read_text()
    for name in INPUTS:
        body = statements_of(recorded, name)
        own = (generated / f'{name}.cpp').read_text()
        head = own[:own.index('noexcept {') + len('noexcept {')]
        tail = own[own.rindex('\n}\n\n}'):]
        statements = in_float(body) if single else body
        (output / f'{name}.cpp').write_text(head + print_sines(body) + statements + tail)


if __name__ == '__main__':
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*(pathlib.Path(argument) for argument in sys.argv[1:]))
