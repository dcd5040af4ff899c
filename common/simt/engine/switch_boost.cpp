// The stack switch with boost.context, for processors that have no switch of their own here.
#include "common/simt/engine/switch.h"

#include <boost/context/detail/fcontext.hpp>

namespace ctx = boost::context::detail;

// A context that is entered by a jump gets the context that jumped, and the place to store it.
static void remember(ctx::transfer_t came) { *static_cast<void**>(came.data) = came.fctx; }

extern "C" {

void* raylab_simt_prepare(void* top, size_t bytes) {
    return ctx::make_fcontext(top, bytes, [](ctx::transfer_t came) {
        remember(came);
        raylab_simt_main();
    });
}

void raylab_simt_switch(void** from, void* to) { remember(ctx::jump_fcontext(to, from)); }
}
