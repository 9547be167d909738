// street_mesh FILE.obj|FILE.ply: the street of the benchmarks as a mesh, for other programs to be timed on.
#include <cstdio>
#include <exception>

#include "bench/street.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: street_mesh FILE.obj|FILE.ply\n", stderr);
    return 2;
  }
  try {
    const auto street = bench::street();
    bench::writeMesh(street, argv[1]);
    std::fprintf(stderr, "%s: %zu triangles, %zu vertices\n", argv[1], street.faces.size(), street.vertices.size());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
  return 0;
}
