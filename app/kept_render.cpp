#include "app/kept_render.h"

#include "common/cli/interrupt.h"

#include <algorithm>
#include <chrono>
#include <mutex>

namespace raylab::app {

namespace {

double now() {
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}

// The last copy of film and ledger that was made while the render goes on.
class SetAside {
  public:
    explicit SetAside(const Scene& scene) : scene_(scene) {}

    void set(const Renderer& renderer) {
        const std::lock_guard lock(mutex_);
        const double begin = now();
        develop(renderer, scene_, kept_);
        time_ = now();
        seconds_ = time_ - begin;
    }
    bool is_due() const { return now() - time_ > std::max(1.0, 50 * seconds_); }

    Render take() {
        const std::lock_guard lock(mutex_);
        return std::move(kept_);
    }

  private:
    const Scene& scene_;
    std::mutex mutex_;
    Render kept_;
    double time_ = now(), seconds_ = 0;
};

} // namespace

Render render_and_keep(const Lab& lab, const Scene& scene, const MachineSettings& machine, int spp,
                       const std::function<void(const Renderer&, int done)>& after_sample,
                       const std::function<void()>& tick) {
    // The thread may still run after this call has returned, so it shares or copies what it uses.
    const auto aside = std::make_shared<SetAside>(scene);
    const auto work = [aside, &lab, &scene, machine, spp, after_sample] {
        const std::unique_ptr<Renderer> renderer = lab.make(scene, machine);
        const auto keep = [&](int done) {
            after_sample(*renderer, done);
            if (aside->is_due()) aside->set(*renderer);
        };
        if (add_samples(*renderer, spp, keep, interrupted) > 0) aside->set(*renderer);
    };
    run_interruptibly(work, tick);
    return aside->take();
}

} // namespace raylab::app
