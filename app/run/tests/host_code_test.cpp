// What clang says about host code in kernels: of the programs of the corpus that ask for it
// ("host") all, of the others, which have nothing of the kind, every twentieth, or all with
// RAYLAB_LONG.
#include "app/run/host_code.h"
#include "app/run/tests/expectation.h"
#include "common/cli/process.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace raylab::app {
namespace {

TEST(HostCode, OfTheCorpusIsFoundAndNothingElse) {
    if (!run_process({"clang++", "--version"}, {.limit_seconds = 10}).succeeded())
        GTEST_SKIP() << "clang is not installed";
    const Tree tree = {RAYLAB_ROOT};
    const std::size_t step = std::getenv("RAYLAB_LONG") ? 1 : 20;
    std::size_t number = 0;
    int asked = 0, looked_at = 0, unchecked = 0;
    for (const CorpusFile& file : read_corpus(tree.root / "tests/machine/cuda")) {
        const bool is_asked = file.expects("host");
        if (file.expects("compile") || (!is_asked && number++ % step != 0)) continue;
        const HostCode found = host_code_in_kernels(tree, {}, {file.path.string()});
        for (const std::string& text : file.missing("host", found.findings))
            ADD_FAILURE() << file.name() << ": not found: " << text;
        if (!is_asked)
            for (const simt::Finding& finding : found.findings)
                ADD_FAILURE() << file.name() << ": surplus: " << finding.message;
        asked += is_asked, ++looked_at;
        unchecked += !found.unchecked.empty();
    }
    EXPECT_GE(asked, 3);
    EXPECT_LE(unchecked * 20, looked_at) << "clang cannot read " << unchecked << " programs";
}

} // namespace
} // namespace raylab::app
