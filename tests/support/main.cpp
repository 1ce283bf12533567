// In version 2 this macro is what compiles Catch2 itself, here and nowhere else.
#define CATCH_CONFIG_RUNNER
#include "catch.hpp"

int main(int argc, char* argv[]) { return Catch::Session().run(argc, argv); }
