"""The app in the browser: forms made from the catalogue, pictures of the method, and the study file behind them.

Reachable from the local machine only.  A page holds the text of a study; a process of its own solves it, by the code of
`winkler.study`, and draws.  Needs the extra ``app``; without it everything else works.
"""
