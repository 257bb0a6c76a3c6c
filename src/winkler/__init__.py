"""Contact mechanics by the method of dimensionality reduction.

A body pressed, rubbed, rolled or heated against another one is replaced by a line of independent springs under a
transformed profile; solved there, exactly where the method is exact; and brought back to pressures and stresses.

>>> import winkler as wk
>>> steel = wk.Elastic(young=210e9, poisson=0.3)
>>> bed = wk.Foundation(wk.Paraboloid(curvature_radius=10e-3), wk.HalfSpace.between(steel, steel))
>>> contact = wk.Indentation(bed, wk.Force(100.0)).solve()
>>> round(contact.radius * 1e6, 3), round(contact.depth * 1e6, 4)
(186.626, 3.4829)
"""

TYPE_CHECKING = False  # the name that type checkers evaluate; `typing` takes longer to load than this module

if TYPE_CHECKING:
    from winkler.public import *  # noqa: F403

    __version__: str
else:
    _MODULES = {}

    def _modules():
        """Return public name -> module, read from the imports of a module that is not run for it."""
        if not _MODULES:
            import ast
            from importlib import import_module
            from importlib.util import find_spec

            page = "winkler.public"
            source = find_spec(page).loader.get_source(page)
            if source is None:  # compiled modules without their text: all names come at once
                _MODULES.update(dict.fromkeys(import_module(page).__all__, page))
                return _MODULES
            imports = [line for line in ast.parse(source).body if isinstance(line, ast.ImportFrom)]
            _MODULES.update({imported.name: line.module for line in imports for imported in line.names})
        return _MODULES

    def __getattr__(name):
        """Load a public name when it is first used, and with it the modules that it needs; see `winkler.public`."""
        if name == "__version__":
            from importlib.metadata import version

            return version("winkler")
        if name.startswith("_") and name != "__all__":  # a search for the nearest name takes time; tools ask for such
            raise AttributeError(f"module 'winkler' has no attribute {name!r}")
        if name == "__all__":
            attribute = sorted([*_modules(), "__version__"])
        elif name in _modules():
            from importlib import import_module

            attribute = getattr(import_module(_modules()[name]), name)
        else:
            from winkler.values.errors import suggest

            near = suggest(name, __getattr__("__all__"))
            raise AttributeError(f"module 'winkler' has no attribute {name!r}{near}", name=name)
        globals()[name] = attribute
        return attribute

    def __dir__():
        """List the names that a person writes: all public ones but the answers, which problems return."""
        return [name for name in __getattr__("__all__") if not name.endswith("Solution")]
