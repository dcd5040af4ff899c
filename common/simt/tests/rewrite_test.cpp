// The rewriter: what it turns into what, and that it leaves all else alone, to the character.
#include "common/simt/rewrite/rewrite.h"
#include "common/simt/rewrite/tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace raylab::simt {
namespace {

const std::string head = "#line 1 \"f.cu\"\n";

std::string rewritten(const std::string& source) {
    std::string out = rewrite(source, "f.cu");
    EXPECT_EQ(out.substr(0, head.size()), head);
    return out.substr(head.size());
}

// `k<<<c>>>` as it comes out.
std::string launch(const std::string& kernel, const std::string& configuration) {
    return "::raylab::simt::launcher(RAYLAB_KERNEL(" + kernel + "), " + configuration + ")";
}

std::string error_of(const std::string& source) {
    try {
        rewrite(source, "f.cu");
    } catch (const RewriteError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Rewrite, FindsTheKernelBeforeTheConfiguration) {
    struct Case {
        std::string before, kernel;
    };
    for (auto& [before, kernel] : {Case{"", "k"},
                                   {"{ ", "k"},
                                   {"if (x) ", "k"},
                                   {"if (x > 1) ", "(k)"},
                                   {"while (f(x)) ", "(*k)"},
                                   {"else ", "k"},
                                   {"return ", "k"},
                                   {"a = b; ", "k"},
                                   {"x > ", "k"},
                                   {"label: ", "k"},
                                   {"f(1); ", "a::b::k"},
                                   {"", "::k"},
                                   {"; ", "::a::k"},
                                   {"", "k<3>"},
                                   {"", "k<F, 3>"},
                                   {"", "k<A<B<int>>, (1 > 2)>"},
                                   {"", "ns::k<a::B, sizeof(x[1])>"},
                                   {"", "T<int>::k"},
                                   {"", "object.template k<3>"},
                                   {"", "object.kernels[i + 1]"},
                                   {"", "p->k"},
                                   {"", "this->f(a, b).k"},
                                   {"", "choose(mode, 'x')"},
                                   {"{ ", "(choose(1))"}})
        EXPECT_EQ(rewritten(before + kernel + "<<<1, 2>>>(a)"),
                  before + launch(kernel, "1, 2") + "(a)");
}

TEST(Rewrite, KeepsConfigurationAndArgumentsAsTheyAre) {
    EXPECT_EQ(rewritten("k<<<dim3(1, 2), (n + 255) >> 8, 0, s>>>(a, 0);"),
              launch("k", "dim3(1, 2), (n + 255) >> 8, 0, s") + "(a, 0);");
    EXPECT_EQ(rewritten("k<<<g<3>(n), b[2]>>>(f({1, 2}), x < y, x >> 3, \"<<<\");"),
              launch("k", "g<3>(n), b[2]") + "(f({1, 2}), x < y, x >> 3, \"<<<\");");
    EXPECT_EQ(rewritten("k<<<a, b>>>([&] { h<<<1, 1>>>(); return 2; }());"),
              launch("k", "a, b") + "([&] { " + launch("h", "1, 1") + "(); return 2; }());");
    EXPECT_EQ(rewritten("n = 1'000; k<<<1, 2>>>(a); c = 'x';"),
              "n = 1'000; " + launch("k", "1, 2") + "(a); c = 'x';");
    EXPECT_EQ(rewritten("#define GO(k, n) \\\n    k<<<1, n>>>(n)\n"),
              "#define GO(k, n) \\\n    " + launch("k", "1, n") + "(n)\n");
}

TEST(Rewrite, LeavesEverythingElseAlone) {
    for (std::string source :
         {"// k<<<1, 1>>>(a)\n", "/* k<<<1,\n 1>>>(a) */ int x;", "auto s = \"k<<<1, 1>>>(a)\";",
          "auto s = R\"(k<<<1, 1>>>(\"a\"))\";", "auto s = u8R\"x(k<<<1, 1>>>(a))\" )x\";",
          "auto s = \"\\\"\"; // \" k<<<1, 1>>>(a)",
          "char c = '\"'; char d = '\\''; int n = 1'000'000;", "#include <a<<<b>>>(c)>\n",
          "#error don't k<<<1, 1>>>(a)\n", "x = a << b; y = c >> d;", "out << 1 << 2;",
          "using std::operator<<<char>;", "a < b; A<B<C<int>>>(3);",
          "auto s = R\"(\" k<<<1, 1>>>(a) \")\";", "extern int x[];",
          "extern \"C\" { extern float y[]; }", "__shared__ float s[4];",
          "int a = 1; // don't\nchar c = 'k';", ""})
        EXPECT_EQ(rewritten(source), source);
}

TEST(Rewrite, MakesAPointerOfDynamicSharedMemory) {
    auto in_function = [](const std::string& text) { return "void k() { " + text + " }"; };
    auto pointer = [](const std::string& variable, const std::string& type) {
        return variable + " = ::raylab::simt::dynamic_shared<" + type + ">();";
    };
    for (auto& [before, after] :
         {std::pair<std::string, std::string>{"extern __shared__ float s[];",
                                              pointer("float* s", "float")},
          {"extern __shared__ T s [ ] ;", pointer("T* s", "T")},
          {"extern __shared__ __align__(16) unsigned char s[];",
           pointer("unsigned char* s", "unsigned char")},
          {"extern __align__(8) volatile __shared__ int s[];",
           pointer("volatile int* s", "volatile int")},
          {"extern __shared__ alignas(16) std::uint8_t s[];",
           pointer("std :: uint8_t* s", "std :: uint8_t")},
          {"extern __shared__ A<int, 3> s[];", pointer("A < int , 3 >* s", "A < int , 3 >")},
          {"extern __shared__ float s[][16];", pointer("float (*s)[16]", "float[16]")}})
        EXPECT_EQ(rewritten(in_function(before)), in_function(after));
}

TEST(Rewrite, KeepsEveryLineItsNumber) {
    std::string source =
        "a\nk\n<<<\n1,\n2\n>>>\n(\na)\n;void f() {\nextern __shared__\nfloat\ns[];\n} b";
    std::string out = rewritten(source);
    EXPECT_EQ(std::count(out.begin(), out.end(), '\n'),
              std::count(source.begin(), source.end(), '\n'));
    EXPECT_EQ(out.substr(out.size() - 3), "} b");
}

TEST(Rewrite, ErrorsNameTheLine) {
    EXPECT_EQ(error_of("a\nk<<<1, 1;\n").substr(0, 27), "f.cu:2: error: this <<< has");
    EXPECT_EQ(error_of("\n\n(k<<<1, 1)").substr(0, 27), "f.cu:3: error: this <<< has");
    EXPECT_EQ(error_of("x = <<<1, 1>>>(a);").substr(0, 30), "f.cu:1: error: there is no ker");
    EXPECT_EQ(error_of("namespace a {\nextern __shared__ float s[];\n}").substr(0, 34),
              "f.cu:2: error: extern __shared__ s");
}

std::string foreign(const std::string& source) {
    std::string out = rewrite_foreign(source, "f.cu", [](std::string_view name) {
        if (name == "\"own.h\"") return Include{"\"/copies/own.h\"", ""};
        if (name == "<cublas_v2.h>") return Include{"", "no cuBLAS"};
        return Include{};
    });
    EXPECT_EQ(out.substr(0, head.size()), head);
    return out.substr(head.size());
}

std::string foreign_error(const std::string& source) {
    try {
        return "no error: " + foreign(source);
    } catch (const RewriteError& error) {
        return error.what();
    }
}

TEST(RewriteForeign, TakesWhatNvccTakes) {
    for (auto& [before, after] : std::vector<std::pair<std::string, std::string>>{
             {"k << <1, 2 >> >(a);", launch("k ", "1, 2 ") + "(a);"},
             {"k << < 1, 2 >> > (a);", launch("k ", " 1, 2 ") + " (a);"},
             {"static __inline__ __device__ __forceinline__ int f();",
              "static __inline__ __device__  int f();"},
             {"__noinline__ void f(); __attribute__((__noinline__)) void g();",
              "__attribute__((noinline)) void f(); __attribute__((__noinline__)) void g();"},
             {"cudaLaunchKernel((void*)k, g, b, a);", "cudaLaunchKernel(k, g, b, a);"},
             {"cudaLaunchCooperativeKernel((const void *)k<3>, g);",
              "cudaLaunchCooperativeKernel(k<3>, g);"},
             {"cudaLaunchKernel(reinterpret_cast<void*>(k), g);", "cudaLaunchKernel((k), g);"},
             {"#include \"own.h\"\n#include <vector>\n",
              "#include \"/copies/own.h\"\n#include <vector>\n"},
             {"asm volatile(\"pause\"); asm(\"rdtsc\" : \"=a\"(low), \"=d\"(high));",
              "asm volatile(\"pause\"); asm(\"rdtsc\" : \"=a\"(low), \"=d\"(high));"},
             {"void f() { extern __shared__ int n; }",
              "void f() { int& n = *::raylab::simt::dynamic_shared<int>(); }"}})
        EXPECT_EQ(foreign(before), after);
    EXPECT_NE(foreign("extern __shared__ float s[];").find("DynamicShared<float> s{};"),
              std::string::npos);
}

TEST(RewriteForeign, RefusesInOneSentenceWithTheLine) {
    EXPECT_EQ(foreign_error("\n#include <cublas_v2.h>\n"), "f.cu:2: error: no cuBLAS");
    EXPECT_EQ(foreign_error("#ifndef A\n#define A\n#include <cublas_v2.h>\n#endif\n"),
              "f.cu:3: error: no cuBLAS");
    EXPECT_EQ(
        foreign_error("void f() {\nasm(\"mov.u32 %0, %%laneid;\" : \"=r\"(x)); }").substr(0, 27),
        "f.cu:2: error: inline PTX r");
    EXPECT_EQ(foreign_error("__global__ void k() {\n if (x)\nk<<<1, 1>>>(); }").substr(0, 34),
              "f.cu:3: error: a kernel launches a");
}

TEST(RewriteTree, CopiesIncludeCopiesAndNameTheOriginals) {
    namespace fs = std::filesystem;
    fs::path home = fs::path(testing::TempDir()) / "raylab_tree", out = home / "out";
    fs::remove_all(home);
    auto write = [&](const fs::path& name, const std::string& text) {
        fs::create_directories((home / name).parent_path());
        std::ofstream(home / name) << text;
    };
    auto read = [](const fs::path& file) {
        std::ifstream in(file);
        return std::string(std::istreambuf_iterator<char>(in), {});
    };
    write("program/main.cu",
          "#include \"sub/a.cuh\"\n#include \"../common/b.h\"\n#include <c.h>\n");
    write("program/sub/a.cuh", "#pragma once\n#include \"../main.h\"\n#include \"absent.h\"\n");
    write("program/main.h", "#include \"sub/a.cuh\"\nk << <1, 1 >> >();\n");
    write("common/b.h", "\xef\xbb\xbf"
                        "extern __shared__ int n[];\n");
    write("elsewhere/c.h", "int c;\n");

    fs::path source = home / "program/main.cu";
    fs::path copy = rewrite_tree(source, out, {home / "elsewhere"});
    EXPECT_EQ(read(copy), "#include <cuda_runtime.h>\n#line 1 \"" + source.string() +
                              "\"\n#include \"" + (out / "sub/a.cuh").string() + "\"\n#include \"" +
                              (out / "up/common/b.h").string() + "\"\n#include \"" +
                              (out / "up/elsewhere/c.h").string() + "\"\n");
    EXPECT_EQ(read(out / "sub/a.cuh"), "#line 1 \"" + (home / "program/sub/a.cuh").string() +
                                           "\"\n#pragma once\n#include \"" +
                                           (out / "main.h").string() +
                                           "\"\n#include \"absent.h\"\n");
    EXPECT_NE(read(out / "main.h").find("launcher("), std::string::npos);
    EXPECT_NE(read(out / "up/common/b.h").find("DynamicShared<int> n"), std::string::npos);

    write("program/main.h", "\n#include <cufft.h>\n");
    try {
        rewrite_tree(source, out, {});
        ADD_FAILURE() << "cuFFT was not refused";
    } catch (const RewriteError& error) {
        EXPECT_EQ(std::string(error.what())
                      .find((home / "program/main.h").string() +
                            ":2: error: cuFFT (cufft.h) is not on the CPU"),
                  0u)
            << error.what();
    }
    write("thrust/thrust/version.h", "");
    write("program/main.h", "#include <thrust/sort.h>\n");
    EXPECT_EQ(read(rewrite_tree(source, out, {home / "thrust"}))
                  .find("#ifndef THRUST_DEVICE_SYSTEM\n#define THRUST_DEVICE_SYSTEM "
                        "THRUST_DEVICE_SYSTEM_CPP\n#endif\n#include <cuda_runtime.h>\n"),
              0u);
    write("program/main.h", "#include <cub/cub.cuh>\n#include <cub/block/block_reduce.cuh>\n");
    EXPECT_NO_THROW(rewrite_tree(source, out, {}));
    write("program/main.h", "#include <cub/device/device_scan.cuh>\n");
    EXPECT_THROW(rewrite_tree(source, out, {}), RewriteError) << "there are no algorithms of CUB's";
    EXPECT_THROW(rewrite_tree(home / "none.cu", out, {}), std::runtime_error);
    fs::remove_all(home);
}

TEST(RewriteForeign, TextureReferencesGetTheirType) {
    EXPECT_EQ(foreign("texture<float, 2> t;"), "::raylab::simt::TextureReference<float, 2> t;");
    for (std::string source : {"template <class T> class texture {}; texture<int> t;",
                               "cudaTextureObject_t texture; f(texture);"})
        EXPECT_EQ(foreign(source), source);
}

TEST(RewriteForeign, LeavesToTheCompilerWhatItMaySkip) {
    EXPECT_EQ(foreign("#ifdef USE_BLAS\n  #include <cublas_v2.h>\n#endif\n"),
              "#ifdef USE_BLAS\n  #pragma GCC error \"no cuBLAS\"\n#endif\n");
    EXPECT_EQ(foreign("#define LANE(x) asm(\"mov.u32 %0, %%laneid;\" : \"=r\"(x))\n").substr(0, 35),
              "#define LANE(x) _Pragma(\"GCC error ");
}

} // namespace
} // namespace raylab::simt
