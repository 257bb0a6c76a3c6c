"""What translated kernels need beside C's own functions; only what a kernel uses is written."""

from __future__ import annotations

from winkler.exporting.translation.tree import TranslatedType

SCALARS = {"real": "double", "int": "int64_t", "bool": "bool", "void": "void"}
WORDS = (
    "auto break case char const continue default do double else enum extern float for goto if inline int long register "
    "restrict return short signed sizeof static struct switch typedef union unsigned void volatile while bool true "
    "false asm catch class delete friend mutable namespace new operator private protected public template this throw "
    "try typename using virtual and or not xor NAN INFINITY free calloc abort fabs llabs isnan isfinite isinf pow sqrt "
    "exp expm1 log log1p sin cos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh hypot copysign floor ceil "
    "erf erfc fmod main near far"
)
RESERVED = frozenset(WORDS.split())
"""Names that no variable may have in C or C++, or that functions have which kernels call."""

FUNCTIONS = {
    "min_real": "static inline double {p}min_real(double a, double b) {{ return b < a ? b : a; }}",
    "max_real": "static inline double {p}max_real(double a, double b) {{ return b > a ? b : a; }}",
    "min_int": "static inline int64_t {p}min_int(int64_t a, int64_t b) {{ return b < a ? b : a; }}",
    "max_int": "static inline int64_t {p}max_int(int64_t a, int64_t b) {{ return b > a ? b : a; }}",
    "square": "static inline double {p}square(double a) {{ return a * a; }}",
    "floor_div_int": """static inline int64_t {p}floor_div_int(int64_t a, int64_t b) {{
    const int64_t q = a / b;
    return q - ((a % b != 0) && ((a % b < 0) != (b < 0)));
}}""",
    "modulo_int": """static inline int64_t {p}modulo_int(int64_t a, int64_t b) {{
    const int64_t r = a % b;
    return r != 0 && (r < 0) != (b < 0) ? r + b : r;
}}""",
    "floor_div_real": "static inline double {p}floor_div_real(double a, double b) {{ return floor(a / b); }}",
    "modulo_real": """static inline double {p}modulo_real(double a, double b) {{
    const double r = fmod(a, b);
    return r != 0.0 && (r < 0.0) != (b < 0.0) ? r + b : r;
}}""",
    "row_sum": """static inline double {p}row_sum({row} a) {{
    double s = 0.0;
    for (int64_t i = 0; i < a.size[0]; ++i) s += a.data[i];
    return s;
}}""",
    "row_min": """static inline double {p}row_min({row} a) {{
    double s = a.data[0];
    for (int64_t i = 1; i < a.size[0]; ++i) s = a.data[i] < s ? a.data[i] : s;
    return s;
}}""",
    "row_max": """static inline double {p}row_max({row} a) {{
    double s = a.data[0];
    for (int64_t i = 1; i < a.size[0]; ++i) s = a.data[i] > s ? a.data[i] : s;
    return s;
}}""",
    "row_search": """static inline int64_t {p}row_search({row} a, double x) {{
    int64_t low = 0, high = a.size[0];
    while (low < high) {{
        const int64_t middle = low + (high - low) / 2;
        if (a.data[middle] < x) low = middle + 1;
        else high = middle;
    }}
    return low;
}}""",
    "new": """static inline void *{p}new(int64_t count, size_t size) {{
    void *made = calloc(count > 0 ? (size_t)count : 1, size);
    if (!made) abort();
    return made;
}}""",
}
"""Name -> definition; `p` is the prefix of the file, `row` its type of a row."""


def type_name(kind: TranslatedType) -> str:
    """Return the part of a name that stands for a type."""
    if kind.kind == "array":
        return f"{kind.item.kind}{kind.axes}"
    if kind.kind == "tuple":
        return "tuple_" + "".join(_letters(part) for part in kind.parts)
    return kind.kind


def _letters(kind: TranslatedType) -> str:
    """Return what stands for the entry of a tuple in its name."""
    if kind.kind == "tuple":
        return "t" + "".join(_letters(part) for part in kind.parts) + "e"
    return f"{kind.item.kind[0]}{kind.axes}" if kind.kind == "array" else kind.kind[0]


def c_type(kind: TranslatedType, prefix: str) -> str:
    """Return a type in C."""
    return SCALARS.get(kind.kind) or f"{prefix}{type_name(kind)}"


def helper(kind: TranslatedType, prefix: str) -> str:
    """Return the definition of a type, and what makes it of its parts."""
    own = c_type(kind, prefix)
    if kind.kind == "slice":
        return f"""typedef struct {{ int64_t start, stop; }} {own};
static inline {own} {prefix}make_slice(int64_t start, int64_t stop) {{
    {own} r; r.start = start; r.stop = stop; return r;
}}"""
    if kind.kind == "array":
        item = c_type(kind.item, prefix)
        strides = f" int64_t stride[{kind.axes - 1}];" if kind.axes > 1 else ""
        sizes = ", ".join(f"int64_t n{k}" for k in range(kind.axes))
        fill = " ".join(f"r.size[{k}] = n{k};" for k in range(kind.axes))
        for k in range(kind.axes - 1):
            fill += f" r.stride[{k}] = " + " * ".join(f"n{j}" for j in range(k + 1, kind.axes)) + ";"
        return f"""typedef struct {{ {item} *data; int64_t size[{kind.axes}];{strides} }} {own};
static inline {own} {prefix}make_{type_name(kind)}({item} *data, {sizes}) {{
    {own} r; r.data = data; {fill} return r;
}}"""
    members = " ".join(f"{c_type(part, prefix)} v{k};" for k, part in enumerate(kind.parts))
    takes = ", ".join(f"{c_type(part, prefix)} v{k}" for k, part in enumerate(kind.parts))
    fill = " ".join(f"r.v{k} = v{k};" for k in range(len(kind.parts)))
    return f"""typedef struct {{ {members} }} {own};
static inline {own} {prefix}make_{type_name(kind)}({takes}) {{
    {own} r; {fill} return r;
}}"""


def view_helper(kind: TranslatedType, pattern: str, prefix: str) -> str:
    """Return what makes a part of an array; `pattern` has i for an index, s for a slice, a for a whole axis."""
    left = kind.axes - pattern.count("i")
    result = TranslatedType("array", kind.parts, left)
    own, new = c_type(kind, prefix), c_type(result, prefix)
    takes, lines, axis = [f"{own} a"], [f"{new} r; int64_t at = 0;"], 0
    for k, mark in enumerate(pattern):
        stride = f" * a.stride[{k}]" if k < kind.axes - 1 else ""
        if mark == "i":
            takes.append(f"int64_t i{k}")
            lines.append(f"at += i{k}{stride};")
            continue
        if mark == "s":
            takes.append(f"{prefix}slice s{k}")
            lines.append(f"if (s{k}.stop > a.size[{k}]) s{k}.stop = a.size[{k}];")
            lines.append(f"at += s{k}.start{stride};")
            lines.append(f"r.size[{axis}] = s{k}.stop > s{k}.start ? s{k}.stop - s{k}.start : 0;")
        else:
            lines.append(f"r.size[{axis}] = a.size[{k}];")
        if axis < left - 1:
            lines.append(f"r.stride[{axis}] = a.stride[{k}];")
        axis += 1
    lines.append("r.data = a.data + at; return r;")
    body = "\n    ".join(lines)
    return f"static inline {new} {prefix}view_{pattern}_{kind.item.kind}({', '.join(takes)}) {{\n    {body}\n}}"
