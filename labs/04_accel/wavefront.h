// All that lies in the device's memory while lab 04 renders, and a launch for every stage. In which
// order they run is the renderer's business: renderer.cu.
#pragma once

#include "common/device/device_scene.h"
#include "common/render/renderer.h"
#include "common/wavefront/compact.h"
#include "common/wavefront/result_arrays.h"
#include "common/wavefront/stage_clock.h"
#include "labs/04_accel/accel.h"
#include "labs/04_accel/kernels.h"
#include "labs/04_accel/stages.h"

namespace raylab::lab04 {

class Wavefront {
  public:
    // The scene must outlive this. accel: over its shapes.
    Wavefront(const Scene& scene, const MachineSettings& machine, Accel accel, int pool_paths);

    // Begins anew; see Renderer::restart().
    void restart(const Camera& camera, std::uint32_t seed);

    // Every stage from here on works for this sample.
    void begin_sample(std::uint32_t sample);

    // Fills slots 0 ... n - 1 with the paths of the pixels from `first` on.
    void generate(int first, int n);
    void walk(int bounce); // through the trees
    void intersect();      // the other shapes
    void shade();
    void trace_shadow_rays(); // that shade() sent: through the trees, past the other shapes
    void remove_ended(int bounce);
    void accumulate(int n); // slots 0 ... n - 1

    const Camera& camera() const { return scene_.view().camera; }
    int alive() const { return alive_; } // paths
    int most_bounces() const { return most_bounces_; }
    const Accel& accel() const { return accel_; }
    const ResultArrays& results() const { return results_; }
    const WalkTallies& walks() const { return walks_; }
    const std::vector<StageCounts>& stage_counts() const { return clock_->counts(); }

    // The first ray of this sample whose walk did not end; found == 0: all did.
    EndlessRay endless_ray() const { return endless_.to_host().front(); }

  private:
    void launch(Stage stage, StageKernel* kernel, const int* slots, int n);
    void launch_walk(Stage stage, StageKernel* kernel, const int* slots, int n, WalkTally* tally);

    // Runs work(), which launches `blocks` blocks, on the stage's account.
    template <class Work> void timed(Stage stage, int blocks, const Work& work) {
        clock_->time(stage, blocks, std::uint64_t{1} * blocks * machine_.block_size, work);
    }

    MachineSettings machine_;
    DeviceScene scene_;     // whose camera is the last restart's,
    RenderSettings render_; // and whose seed
    Accel accel_;
    StageKernels kernels_;
    int most_bounces_;

    SlotMemory memory_;
    PoolView pool_;
    DeviceArray<WavefrontView> view_;
    DeviceArray<int> live_, spare_; // slots of the paths alive, and room for the next such list
    int alive_ = 0;                 // slots in live_
    Compaction compaction_;
    DeviceArray<int> shadow_rays_, shadow_rays_sent_;
    DeviceArray<WalkCounts> walk_counts_;
    DeviceArray<EndlessRay> endless_;

    ResultArrays results_;
    WalkTallies walks_;
    std::unique_ptr<StageClock> clock_ = std::make_unique<StageClock>(stage_names);
};

} // namespace raylab::lab04
