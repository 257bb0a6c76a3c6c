"""What a file is taken for: columns, what was done, what is doubtful, and the study to start from."""
