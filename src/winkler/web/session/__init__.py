"""The session of a page: worker process, uploads, exports, and checks of requests."""
