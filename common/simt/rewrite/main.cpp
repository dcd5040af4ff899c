// simt_rewrite IN.cu OUT.cpp [NAME]: makes a .cu file fit for a host compiler (rewrite.h). NAME is
// what __FILE__ and compiler errors call it, IN.cu if absent. Exit codes: 0 done, 1 the source
// cannot be rewritten, 2 wrong usage, 3 a file cannot be read or written.
#include "common/simt/rewrite/rewrite.h"

#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>

int main(int argc, char** argv) {
    if (argc != 3 && argc != 4) {
        std::cerr << "usage: simt_rewrite IN.cu OUT.cpp [NAME]\n";
        return 2;
    }
    std::ifstream in(argv[1], std::ios::binary);
    std::stringstream source;
    source << in.rdbuf();
    if (!in) {
        std::cerr << argv[1] << ": error: cannot be read\n";
        return 3;
    }
    std::string out;
    try {
        out = raylab::simt::rewrite(source.str(), argv[argc - 1 == 3 ? 3 : 1]);
    } catch (const raylab::simt::RewriteError& error) {
        std::cerr << error.what() << "\n";
        return 1;
    }
    std::string unfinished = std::string(argv[2]) + ".new";
    std::ofstream file(unfinished, std::ios::binary);
    file << out;
    file.close();
    if (!file || std::rename(unfinished.c_str(), argv[2]) != 0) {
        std::cerr << argv[2] << ": error: cannot be written\n";
        return 3;
    }
    return 0;
}
