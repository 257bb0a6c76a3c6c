"""What runs behind a page: the worker process, uploads, exports, and which requests are answered."""
