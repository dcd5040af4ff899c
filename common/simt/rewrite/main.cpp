// simt_rewrite IN.cu OUT.cpp [NAME]: makes a .cu file fit for a host compiler (rewrite.h). NAME is
// what __FILE__ and compiler errors call it, IN.cu if absent.
//
// simt_rewrite --tree IN.cu OUT_FOLDER [INCLUDE_FOLDER...]: the same for a program that was not
// written for raylab, with the headers of its own (tree.h). Prints the path of IN.cu's copy.
//
// Exit codes: 0 done, 1 the source cannot be rewritten, 2 wrong usage, 3 a file cannot be read or
// written.
#include "common/simt/rewrite/rewrite.h"
#include "common/simt/rewrite/tree.h"

#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>

static int rewrite_file(const char* in_path, const std::string& out_path, const char* name) {
    std::ifstream in(in_path, std::ios::binary);
    std::stringstream source;
    source << in.rdbuf();
    if (!in) throw std::runtime_error(std::string(in_path) + ": error: cannot be read");
    std::string out = raylab::simt::rewrite(source.str(), name);
    std::string unfinished = out_path + ".new";
    std::ofstream file(unfinished, std::ios::binary);
    file << out;
    file.close();
    if (!file || std::rename(unfinished.c_str(), out_path.c_str()) != 0)
        throw std::runtime_error(out_path + ": error: cannot be written");
    return 0;
}

int main(int argc, char** argv) {
    bool tree = argc >= 4 && std::string(argv[1]) == "--tree";
    if (!tree && argc != 3 && argc != 4) {
        std::cerr << "usage: simt_rewrite IN.cu OUT.cpp [NAME]\n"
                     "       simt_rewrite --tree IN.cu OUT_FOLDER [INCLUDE_FOLDER...]\n";
        return 2;
    }
    try {
        if (!tree) return rewrite_file(argv[1], argv[2], argv[argc - 1 == 3 ? 3 : 1]);
        std::cout << raylab::simt::rewrite_tree(argv[2], argv[3], {argv + 4, argv + argc}).string()
                  << "\n";
        return 0;
    } catch (const raylab::simt::RewriteError& error) {
        std::cerr << error.what() << "\n";
        return 1;
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 3;
    }
}
