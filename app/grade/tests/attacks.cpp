#include "app/grade/tests/attacks.h"

namespace raylab {

namespace {

const std::string headers = "#include \"common/transport/direct_light.h\"\n";
const std::string in_path = "    record = {};\n"; // begins a path
const std::string in_lab = "namespace raylab::lab02 {\n";

// Runs before main(), in the tests and in the program that draws.
std::string early(const std::string& include, const std::string& what) {
    return headers + include + "namespace { struct Early { Early() { " + what + " } } early; }\n";
}

Attack before_main(const std::string& name, const std::string& row, const std::string& include,
                   const std::string& what) {
    return {name, row, "path.h", headers, early(include, what), {"SUSPICIOUS"}};
}

Attack in_each_path(const std::string& name, const std::string& row, const std::string& what,
                    const std::vector<std::string>& verdicts, int points = 15) {
    return {name, row, "path.h", in_path, in_path + what, verdicts, points};
}

Attack anywhere(const std::string& name, const std::string& row, const std::string& what,
                const std::vector<std::string>& verdicts) {
    return {name, row, "path.h", headers, headers + what, verdicts};
}

Attack short_too(Attack attack) {
    attack.always = true;
    return attack;
}

std::vector<Attack> all() {
    const std::vector<std::string> suspicious = {"SUSPICIOUS"};
    std::vector<Attack> list = {
        // Forged verdicts.
        short_too(before_main("ends with exit code 0 before the tests", "14",
                              "#include <unistd.h>\n", "_exit(0);")),
        before_main("calls exit()", "14", "#include <cstdlib>\n", "std::exit(0);"),
        anywhere("has a main() of its own", "12", "int main() { return 0; }\n",
                 {"SUSPICIOUS", "COMPILE_ERROR"}),
        anywhere(
            "replaces operator new", "12",
            "#include <cstdlib>\nvoid* operator new(std::size_t n) { return std::malloc(n); }\n",
            {"SUSPICIOUS", "COMPILE_ERROR"}),
        short_too({"words of the tests that always agree", "13", "path.h", in_lab,
                   in_lab + "template <class... A> bool expect(A&&...) { return true; }\n"
                            "template <class... A> bool expect_equal(A&&...) { return true; }\n"
                            "template <class... A> bool expect_near(A&&...) { return true; }\n",
                   suspicious}),
        anywhere("a macro in place of the tests' words", "13",
                 "#define expect_near(...) true\n#define expect(...) true\n",
                 {"SUSPICIOUS", "COMPILE_ERROR"}),
        anywhere("names GoogleTest's classes", "13",
                 "namespace testing { class UnitTest { public: static UnitTest* GetInstance(); "
                 "void* x; }; }\n"
                 "namespace { void* forged = testing::UnitTest::GetInstance(); }\n",
                 {"SUSPICIOUS", "COMPILE_ERROR"}),
        // The system.
        before_main("forks", "4", "#include <unistd.h>\n", "while (true) fork();"),
        before_main("kills everybody", "3", "#include <csignal>\n", "kill(-1, SIGKILL);"),
        before_main("starts a shell", "33", "#include <cstdlib>\n",
                    "if (std::system(\"id\")) std::abort();"),
        before_main("opens a file", "1", "#include <fcntl.h>\n",
                    "if (open(\"/etc/passwd\", O_RDONLY) < 0) throw 1;"),
        before_main("reads a file by a stream", "1", "#include <fstream>\n",
                    "std::ifstream(\"/etc/passwd\");"),
        before_main("looks through folders", "1", "#include <filesystem>\n",
                    "std::filesystem::exists(\"/work\");"),
        before_main("starts threads", "5", "#include <thread>\n",
                    "for (int i = 0; i < 100000; ++i) std::thread([] { for (;;) {} }).detach();"),
        before_main("opens a socket", "28", "#include <sys/socket.h>\n",
                    "socket(AF_INET, SOCK_STREAM, 0);"),
        before_main("maps memory", "42", "#include <sys/mman.h>\n",
                    "mmap(nullptr, 4096, PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);"),
        before_main("loads a library", "38", "#include <dlfcn.h>\n", "dlopen(\"x.so\", RTLD_NOW);"),
        before_main("traces its parent", "42", "#include <sys/ptrace.h>\n",
                    "ptrace(PTRACE_ATTACH, 1, 0, 0);"),
        before_main("reads the environment", "48", "#include <cstdlib>\n",
                    "if (std::getenv(\"RAYLAB_ORDER\")) throw 1;"),
        before_main("calls the kernel by an instruction", "42", "",
                    "long r; asm volatile(\"syscall\" : \"=a\"(r) : \"a\"(60), \"D\"(0) : \"rcx\", "
                    "\"r11\");"),
        // Limits: where only a path is attacked, task 2.5 keeps its 15 points.
        short_too(in_each_path("never ends", "6", "    for (volatile bool on = true; on;) {}\n",
                               {"TIME_LIMIT", "CRASH"})),
        in_each_path("takes all memory", "8",
                     "    for (;;) { volatile char* block = new char[1 << 22];\n"
                     "        for (int i = 0; i < 1 << 22; i += 4096) block[i] = 1; }\n",
                     {"MEMORY_LIMIT"}),
        in_each_path("prints without end", "22", "    for (;;) printf(\"all tests passed\\n\");\n",
                     {"OUTPUT_LIMIT"}),
        in_each_path(
            "writes to address 0", "18",
            "    *reinterpret_cast<volatile int*>(static_cast<std::size_t>(record.length)) = 1;\n",
            {"CRASH"}),
        short_too(anywhere("includes an endless file", "34", "#include \"/dev/zero\"\n",
                           {"TIME_LIMIT", "MEMORY_LIMIT", "COMPILE_ERROR"})),
        anywhere("a bomb of templates", "36",
                 "template <int N, long M> struct Bomb : Bomb<N - 1, 2 * M>, Bomb<N - 1, 2 * M + "
                 "1> {};\n"
                 "template <long M> struct Bomb<0, M> {};\ninline Bomb<24, 1>* bomb = new Bomb<24, "
                 "1>;\n",
                 {"TIME_LIMIT", "MEMORY_LIMIT", "COMPILE_ERROR"}),
        // Pictures: tasks 2.5 and 2.6 stay right, and keep their 25 points.
        short_too(in_each_path("knows the size of graded pictures", "29, 32",
                               "    if (scene.camera.width == 96) return Vec3(.3f);\n",
                               {"WRONG_IMAGE", "SUSPICIOUS"}, 25)),
        in_each_path("a hundredth of the pixels are not numbers", "15",
                     "    if (scene.camera.width == 96 && ray.d.x > .2f) return Vec3(NAN);\n",
                     {"WRONG_IMAGE", "NON_FINITE"}, 25),
        in_each_path("negative light", "16", "    if (scene.camera.width == 96) return Vec3(-1);\n",
                     {"WRONG_IMAGE", "SUSPICIOUS"}, 25),
        in_each_path("a fifth too bright", "29",
                     "    if (scene.camera.width == 96) throughput *= 1.2f;\n", {"WRONG_IMAGE"},
                     25),
        {"right for a few samples, wrong later",
         "52",
         "renderer.cu",
         "    add_sample(film[pixel], radiance);\n",
         "    add_sample(film[pixel], iteration.sample > 3 ? Vec3(0) : radiance);\n",
         {"WRONG_IMAGE", "WRONG"},
         40},
        {"ignores the seed where no test looks",
         "29",
         "renderer.cu",
         "    return {settings.sampler, settings.seed,",
         "    return {settings.sampler, pixel > 1100 ? 7u : settings.seed,",
         {"WRONG_IMAGE", "SUSPICIOUS"},
         25},
    };
    return list;
}

} // namespace

const std::vector<Attack>& attacks() {
    static const std::vector<Attack> list = all();
    return list;
}

} // namespace raylab
