// Compiled once, so that the headers that every test includes are read once (tests/CMakeLists.txt).
