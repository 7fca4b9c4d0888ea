// What PAL_PRECOMPILE reads once belongs to a target, and a target has a file.
