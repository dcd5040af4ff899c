// All that lies in the device's memory while lab 03 renders, and a launch for every stage. In which
// order they run is the renderer's business: renderer.cu.
#pragma once

#include "common/device/device_scene.h"
#include "common/wavefront/result_arrays.h"
#include "common/wavefront/stage_clock.h"
#include "labs/03_wavefront/compact.h"
#include "labs/03_wavefront/kernels.h"
#include "labs/03_wavefront/stages.h"

namespace raylab::lab03 {

// In place of a bounce: paths of all bounces share the launch.
inline constexpr int mixed_bounces = -1;

class Wavefront {
  public:
    // The scene must outlive this.
    Wavefront(const Scene& scene, const MachineSettings& machine, int pool_paths);

    // Begins anew; see Renderer::restart().
    void restart(const Camera& camera, std::uint32_t seed);

    // Every stage from here on works for this sample.
    void begin_sample(std::uint32_t sample);

    // Fills slots 0 ... n - 1 with the paths of the pixels from `first` on.
    void generate(int first, int n);
    void intersect(int bounce); // or mixed_bounces
    void sort_by_material();
    void shade();
    void shadow();
    void remove_ended(int bounce); // or counts them, in bounces without compaction
    void accumulate(int n);        // slots 0 ... n - 1
    // In place of the last two: accumulates what has ended and starts the next pixels' paths.
    void regenerate();

    const Camera& camera() const { return scene_.view().camera; }
    int alive() const { return alive_; } // paths
    int most_bounces() const { return most_bounces_; }
    const ResultArrays& results() const { return results_; }
    const std::vector<StageCounts>& stage_counts() const { return clock_->counts(); }

  private:
    void launch(Stage stage, StageKernel* kernel, const int* slots, int n, std::size_t shared = 0);
    void keep_alive();
    Counters read_counters() const { return counters_.to_host().front(); }

    // Runs work(), which launches `blocks` blocks, on the stage's account.
    template <class Work> void timed(Stage stage, int blocks, const Work& work) {
        clock_->time(stage, blocks, std::uint64_t{1} * blocks * machine_.block_size, work);
    }

    MachineSettings machine_;
    WavefrontSettings settings_;
    DeviceScene scene_;     // whose camera is the last restart's,
    RenderSettings render_; // and whose seed
    StageKernels kernels_;
    std::size_t geometry_bytes_; // of shared memory; 0: geometry stays where it is
    int pixels_, most_bounces_;
    int in_flight_; // blocks of the intersect kernel

    SlotMemory memory_;
    PoolView pool_;
    DeviceArray<WavefrontView> view_;
    DeviceArray<int> live_, spare_; // slots of the paths alive, and room for the next such list
    int listed_ = 0;                // slots in live_
    int alive_ = 0;                 // of those, with a path alive
    Compaction compaction_;
    std::array<DeviceArray<int>, material_kinds> kind_queues_;
    DeviceArray<int> shadow_rays_;
    DeviceArray<Counters> counters_;
    DeviceArray<int> next_pixel_; // the first without a path yet, of paths that regenerate
    DeviceArray<Hit> first_hits_; // a pixel each, or none

    ResultArrays results_;
    std::unique_ptr<StageClock> clock_ = std::make_unique<StageClock>(stage_names);
};

} // namespace raylab::lab03
