"""Names with which the functions and files of an exported law cannot begin: words that a language has or a file uses.

One list serves all targets, so that a law keeps its name when it is exported to another one.
"""

from __future__ import annotations

import keyword
import sys

from winkler.values.errors import InvalidInput

__all__ = ["refuse_reserved"]

C = """
alignas alignof auto bool break case char const constexpr continue default do double else enum extern false float for
goto if inline int long main nullptr register restrict return short signed sizeof static struct switch thread_local true
typedef typeof union unsigned void volatile while
assert complex ctype errno fenv inttypes iso646 limits locale math setjmp signal stdalign stdarg stdatomic stdbool
stddef stdint stdio stdlib stdnoreturn string tgmath threads time uchar wchar wctype
"""
"""Words of C, and its headers: a file of the same name in the folder would be taken for them."""
CPP = """
and asm bitand bitor catch class compl concept consteval constinit decltype delete dynamic_cast explicit export friend
mutable namespace new noexcept not operator or private protected public reinterpret_cast requires static_assert
static_cast template this throw try typeid typename using virtual xor std lammps
"""
FORTRAN = """
abs bind block call contains do else end error function if implicit import in inout integer intent interface intrinsic
logical max maxval merge module name none out parameter print procedure program real result stop submodule subroutine
type use
iso_c_binding c_alert c_associated c_backspace c_bool c_carriage_return c_char c_double c_double_complex c_f_pointer
c_f_procpointer c_f_strpointer c_float c_float128 c_float128_complex c_float_complex c_form_feed c_funloc c_funptr
c_horizontal_tab c_int c_int8_t c_int16_t c_int32_t c_int64_t c_int128_t c_int_fast8_t c_int_fast16_t c_int_fast32_t
c_int_fast64_t c_int_fast128_t c_int_least8_t c_int_least16_t c_int_least32_t c_int_least64_t c_int_least128_t
c_intmax_t c_intptr_t c_loc c_long c_long_double c_long_double_complex c_long_long c_new_line c_null_char
c_null_funptr c_null_ptr
c_ptr c_ptrdiff_t c_short c_signed_char c_size_t c_sizeof c_vertical_tab
"""
"""Words of the module and of what it uses: a module cannot have the name of anything within."""
JAVASCRIPT = "arguments await debugger eval extends function instanceof let null super undefined var"
FILES = "aux con nul prn " + " ".join(f"com{k} lpt{k}" for k in range(1, 10))
USED = "answer expected got motion nothing numpy scale state step trial worst"
RESERVED = {
    **dict.fromkeys(USED.split(), "the exported files"),
    **dict.fromkeys(FILES.split(), "Windows, for a device"),
    **dict.fromkeys(sys.stdlib_module_names, "Python"),
    **dict.fromkeys(keyword.kwlist, "Python"),
    **dict.fromkeys(JAVASCRIPT.split(), "JavaScript"),
    **dict.fromkeys(CPP.split(), "C++"),
    **dict.fromkeys(FORTRAN.split(), "Fortran"),
    **dict.fromkeys(C.split(), "C"),
}
"""Word -> whose it is."""


def refuse_reserved(name: str) -> None:
    """Refuse a name that is a word of a target.

    Raises
    ------
    InvalidInput
    """
    if name in RESERVED:
        raise InvalidInput(
            f"export: {name!r} is a word of {RESERVED[name]}, not a name of functions and files; give another, such as "
            "contact."
        )
