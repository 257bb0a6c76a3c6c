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

TYPE_CHECKING = False  # as type checkers know it; `typing` takes longer to load than the rest of this page

if TYPE_CHECKING:
    from winkler.public import *  # noqa: F403

    __version__: str
else:

    def __getattr__(name):
        """Load what the package offers when the first of its names is asked for; see `winkler.public`."""
        if name == "__version__":
            from importlib.metadata import version

            return version("winkler")
        if name.startswith("__") and name != "__all__":
            raise AttributeError(f"module 'winkler' has no attribute {name!r}")
        import winkler.public as door

        names = [*door.__all__, "__version__"]
        globals().update({word: getattr(door, word) for word in door.__all__}, __all__=sorted(names))
        if name not in globals():
            from winkler.errors import suggest

            raise AttributeError(f"module 'winkler' has no attribute {name!r}{suggest(name, names)}", name=name)
        return globals()[name]

    def __dir__():
        """List the public names."""
        return list(__getattr__("__all__"))
