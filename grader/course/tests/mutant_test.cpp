// Each kind of slip, where it can be made and where it cannot; and mutants of a lab, with those
// that a person has called equivalent.
#include "grader/course/code_edits.h"
#include "grader/course/mutant.h"
#include "grader/course/tests/temporary_tree.h"

namespace raylab {

namespace {

// What the edits of one kind make of a piece of code.
std::vector<std::string> made(const std::string& kind, const std::string& code) {
    std::vector<std::string> all;
    for (const CodeEdit& edit : edits_of(code))
        if (edit.kind == kind) all.push_back(edit.apply(code));
    return all;
}

using Texts = std::vector<std::string>;

TEST(CodeEdits, StatementsAreDeleted) {
    const std::string deleted = "statement deleted";
    EXPECT_EQ(made(deleted, "a += b; // c;\nf(a,\n  \";\");\n"),
              (Texts{"; // c;\nf(a,\n  \";\");\n", "a += b; // c;\n;\n"}));
    EXPECT_EQ(made(deleted, "if (x(1)) return y;\nelse\n    continue;\n"),
              (Texts{"if (x(1)) ;\nelse\n    continue;\n", "if (x(1)) return y;\nelse\n    ;\n"}));
    EXPECT_EQ(made(deleted, "for (int i = 0; i < n; ++i) sum += a[i];\n"),
              (Texts{"for (int i = 0; i < n; ++i) ;\n"}));
    EXPECT_EQ(made(deleted, "each([&](int i) {\n    a[i] = 1;\n});\n"),
              (Texts{";\n", "each([&](int i) {\n    ;\n});\n"}));
    // What is declared is needed, and a value must be returned.
    for (const char* code : {"int a = 1;\n", "const float* p = f(q);\n", "Vec3 v(0);\n",
                             "auto x = y;\n", "Stack<int> all[2] = {{1}, {2}};\n", "return x;\n",
                             "int a;\n", "unsigned long n = 0, m = 1;\n", "using A = B;\n"})
        EXPECT_EQ(made(deleted, code), Texts{}) << code;
}

TEST(CodeEdits, BarriersAndFencesAreRemovedAndAtomicsMadePlain) {
    const std::string removed = "barrier, atomic or fence removed";
    EXPECT_EQ(made(removed, "__syncthreads();\n__threadfence();\n"),
              (Texts{";\n__threadfence();\n", "__syncthreads();\n;\n"}));
    EXPECT_EQ(made(removed, "x = atomicAdd(&a[i].n, 1 + k);\n"),
              (Texts{"x = ((a[i].n += 1 + k) - (1 + k));\n"}));
    EXPECT_EQ(made(removed, "atomicAdd(p, n);\n"), (Texts{"((*p += n) - (n));\n"}));
}

TEST(CodeEdits, ComparisonsAndLimits) {
    EXPECT_EQ(made("comparison flipped", "if (a < b && a == b) f<int>(a);\n"),
              (Texts{"if (a > b && a == b) f<int>(a);\n", "if (a < b && a != b) f<int>(a);\n"}));
    EXPECT_EQ(made("limit shifted", "x = a >=\n    b;\n"), (Texts{"x = a >\n    b;\n"}));
}

TEST(CodeEdits, Operators) {
    const std::string flipped = "operator flipped";
    EXPECT_EQ(made(flipped, "p->x = -a + *b;\n"), (Texts{"p->x = a + *b;\n", "p->x = -a - *b;\n"}));
    EXPECT_EQ(
        made(flipped, "const T& a = b; T* c; if (!d) ++e;\n"),
        (Texts{"const T& a = b; T* c; if (d) ++e;\n", "const T& a = b; T* c; if (!d) --e;\n"}));
    EXPECT_EQ(made(flipped, "a <<= 1; b = c % 2;\n"),
              (Texts{"a >>= 1; b = c % 2;\n", "a <<= 1; b = c / 2;\n"}));
    EXPECT_EQ(made(flipped, "kernel<<<a, b>>>(c); // a + b\n#define A 1 + 2\n"), Texts{});
}

TEST(CodeEdits, Constants) {
    EXPECT_EQ(
        made("constant off by one", "Vec3 a(0.5f); b = 1e-5 * 31u + 0xff;\n"),
        (Texts{"Vec3 a(1.5f); b = 1e-5 * 31u + 0xff;\n", "Vec3 a(0.5f); b = 2e-5 * 31u + 0xff;\n",
               "Vec3 a(0.5f); b = 1e-5 * 32u + 0xff;\n"}));
}

TEST(CodeEdits, Indices) {
    EXPECT_EQ(made("index shifted", "int a[n]; b[c[i]] = [&] { return d[--i]; };\n"),
              (Texts{"int a[n]; b[c[i + 1]] = [&] { return d[--i]; };\n",
                     "int a[n]; b[c[i] + 1] = [&] { return d[--i]; };\n",
                     "int a[n]; b[c[i]] = [&] { return d[--i + 1]; };\n"}));
}

TEST(CodeEdits, Operands) {
    const std::string swapped = "operands swapped";
    EXPECT_EQ(made(swapped, "a = b.c - d(e)[1] + f;\n"), (Texts{"a = d(e)[1] - b.c + f;\n"}));
    EXPECT_EQ(made(swapped, "f(a.b, c); max(a, b); g(a, a); h(a, b, c);\n"),
              (Texts{"f(c, a.b); max(a, b); g(a, a); h(a, b, c);\n"}));
}

using Mutants = TemporaryTree;

TEST_F(Mutants, AreOfTasksAloneAndHaveTheirPlace) {
    const LabSources lab = read_lab_sources(read_lab_sheet(root, "07_tiny"));
    const std::vector<Mutant> mutants = mutants_of(lab);
    ASSERT_EQ(mutants.size(), 2u);
    EXPECT_EQ(mutants[0].task, "7.1");
    EXPECT_EQ(mutants[0].line, 3);
    EXPECT_EQ(mutants[1].task, "7.2");
    EXPECT_EQ(mutants[1].file, "a.cpp");
    EXPECT_EQ(mutants[1].line, 8);
    EXPECT_EQ(mutants[1].was, "return 2;");
    EXPECT_EQ(mutants[1].is, "return 3;");
    EXPECT_EQ(student_source(planted(lab, mutants[1]).files[0],
                             [](const MarkedRegion&) { return false; }),
              "int before();\nint one() { return 1; }\nint f() {\n    return 3;\n}\n");
}

TEST_F(Mutants, SomeAreEquivalentForAReason) {
    const LabSheet sheet = read_lab_sheet(root, "07_tiny");
    const auto write_list = [&](const std::string& was) {
        write("labs/07_tiny/equivalent.json",
              R"({"version": 1, "mutants": [{"file": "a.cpp", "was": ")" + was +
                  R"(", "is": "return 3;", "why": "f is not called"}]})");
    };
    write_list("return 2;");
    const std::vector<Mutant> mutants = mutants_of(read_lab_sources(sheet));
    EXPECT_FALSE(mutants[0].why_equivalent);
    EXPECT_EQ(mutants[1].why_equivalent.value_or(""), "f is not called");
    EXPECT_FALSE(is_handed_out(sheet, "equivalent.json"));

    write_list("return 5;");
    try {
        mutants_of(read_lab_sources(sheet));
        ADD_FAILURE() << "an entry that fits no mutant is taken";
    } catch (const CourseError& error) {
        EXPECT_NE(std::string(error.what()).find("no such mutant"), std::string::npos)
            << error.what();
    }
}

} // namespace

} // namespace raylab
