"""What stands first in a report and in the app: the sought numbers, the elastic contact beside them, and the advice."""
