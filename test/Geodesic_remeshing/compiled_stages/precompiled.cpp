// Only carries the precompiled header that tests and examples share.
