"""Writes programs that print and compare the same calls: tests/expected.c in C, tests/bits.rs in Rust; and the calls
as data, tests/calls.json, for other languages.

Usage: write_bits_test.py PACKAGE CRATE. Shapes and arguments are those that the headers of C state."""

import json
import math
import os
import random
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "judges"))
from read_arguments import read_arguments  # noqa: E402

SEED, STATES = 20261129, 5
name, crate = os.path.basename(sys.argv[1]), sys.argv[2]
headers = ""
for file in (f"{name}.h", f"{name}_damped.h", f"{name}_joints.h"):
    path = os.path.join(sys.argv[1], "src", file)
    if os.path.exists(path):
        with open(path, encoding="utf-8") as opened:
            headers += opened.read()
real, bits = ("float", "uint32_t") if f"typedef float {name}_real" in headers else ("double", "uint64_t")
# The profile misra has no macro for the sizes.
headers = re.sub(r"\[(\d+)\](?=[,)])", rf"[TREELINE_{name.upper()}_ARRAY(\1)]", headers)
draw = random.Random(SEED)
c, rust, calls = [], [], []
for function, arguments in read_arguments(headers, name, real):
    for _ in range(STATES):
        given, lent, results, values = [], [], [], {}
        c.append("{")
        rust.append("{")
        for symbol, shape, is_result in arguments:
            size = math.prod(shape)
            values[symbol] = [0.0 if is_result else draw.uniform(0.5, 2) for _ in range(size)]
            numbers = ", ".join(map(repr, values[symbol]))
            c.append(f"{real} {symbol}[] = {{{numbers}}};")
            rust.append(f"let {'mut ' if is_result else ''}{symbol} = [{numbers}];")
            given.append(symbol)
            lent.append(f"&{'mut ' if is_result else ''}{symbol}")
            if is_result:
                results.append((symbol, size))
        returns = re.search(rf"^{real} {name}_{function}\(", headers, re.M)
        c.append(f"{real + ' returned = ' if returns else ''}{name}_{function}({', '.join(given)});")
        rust.append(f"{'let returned = ' if returns else ''}{crate}::{function}({', '.join(lent)});")
        c += [f"show({symbol}, {size});" for symbol, size in results] + ["show(&returned, 1);"] * bool(returns) + ["}"]
        rust += [f"same(&{symbol});" for symbol, _ in results] + ["same(&[returned]);"] * bool(returns) + ["}"]
        calls.append({"function": function, "results": [symbol for symbol, _ in results], "returns": bool(returns),
                      "arguments": [values[symbol] for symbol, _, is_result in arguments if not is_result]})
for kind, array, size in re.findall(rf"static const (char|{real})[^\n=]* {name}_(\w+)\[(\d+)\] =", headers):
    c.append(f"tell({name}_{array}, {size});" if kind == "char" else f"show({name}_{array}, {size});")
    rust.append(f"{'told' if kind == 'char' else 'same'}(&{crate}::{array.upper()});")
constants = re.findall(rf"static const (?:char|{real})[^\n=]* {name}_(\w+)\[\d+\] =", headers)
assert len(calls) >= STATES and len(c) > 8, "the headers were not understood"

with open(os.path.join(sys.argv[1], "tests", "calls.json"), "w", encoding="utf-8") as file:
    json.dump({"real": real, "calls": calls, "constants": constants}, file)
include = f'"../src/{name}_damped.h"' if f"{name}_damped_control_torque(" in headers else f'"../src/{name}.h"'
with open(os.path.join(sys.argv[1], "tests", "expected.c"), "w", encoding="utf-8") as file:
    file.write(f"""#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include {include}
#include "../src/{name}_joints.h"
static void show(const {real}* values, int count) {{
  for (int i = 0; i < count; ++i) {{
    {bits} word;
    memcpy(&word, values + i, sizeof word);
    printf("%" PRIu64 "\\n", (uint64_t)word);
  }}
}}
static void tell(const char* const* texts, int count) {{
  for (int i = 0; i < count; ++i) puts(texts[i]);
}}
int main(void) {{
{chr(10).join(c)}
}}
""")
rust_real = "f32" if real == "float" else "f64"
body = "\n".join(rust)
with open(os.path.join(sys.argv[1], "tests", "bits.rs"), "w", encoding="utf-8") as file:
    file.write(f"""//! Results and constants are those of C.
#[test]
#[allow(non_snake_case)]
fn bits_are_those_of_c() {{
    let lines = std::cell::RefCell::new(include_str!("expected.txt").lines());
    let told = |texts: &[&str]| {{
        for text in texts {{
            assert_eq!(Some(*text), lines.borrow_mut().next());
        }}
    }};
    let same = |values: &[{rust_real}]| {{
        for value in values {{
            assert!(value.is_finite());
            assert_eq!(Some(value.to_bits().to_string().as_str()), lines.borrow_mut().next());
        }}
    }};
{body}
    assert_eq!(None, lines.borrow_mut().next());
}}
""")
# Not under tests, where cargo would take it for a test with the standard library.
with open(os.path.join(sys.argv[1], "bare.rs"), "w", encoding="utf-8") as file:
    file.write(f"""//! The same calls without the standard library: C prints what they give.
#![no_std]
#![allow(non_snake_case)]
extern "C" {{
    fn show(values: *const {rust_real}, count: i32);
    fn tell_bytes(text: *const u8, count: i32);
}}
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {{
    loop {{}}
}}
#[no_mangle]
pub extern "C" fn call_all() {{
    let told = |texts: &[&str]| {{
        for text in texts {{
            unsafe {{ tell_bytes(text.as_ptr(), text.len() as i32) }}
        }}
    }};
    let same = |values: &[{rust_real}]| unsafe {{ show(values.as_ptr(), values.len() as i32) }};
{body}
}}
""")
