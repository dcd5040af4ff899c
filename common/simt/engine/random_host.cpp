// cuRAND's host API; see random/host_api.h.
#include "common/simt/random/host_api.h"

#include <type_traits>
#include <vector>

using raylab::simt::sobol_dimensions;

namespace {

bool is_quasi(const curandGenerator_st& generator) {
    return generator.type >= CURAND_RNG_QUASI_DEFAULT;
}

curandStatus_t create(curandGenerator_t* generator, curandRngType_t type, bool on_host) {
    switch (type) {
    case CURAND_RNG_PSEUDO_DEFAULT:
    case CURAND_RNG_PSEUDO_XORWOW:
    case CURAND_RNG_PSEUDO_PHILOX4_32_10:
    case CURAND_RNG_QUASI_DEFAULT:
    case CURAND_RNG_QUASI_SOBOL32:
    case CURAND_RNG_QUASI_SOBOL64:
        *generator = new curandGenerator_st{type, on_host};
        return CURAND_STATUS_SUCCESS;
    default:
        return CURAND_STATUS_TYPE_ERROR;
    }
}

template <class State, class T, class Draw>
void draw_pseudo(curandGenerator_st& generator, std::vector<T>& numbers, Draw draw) {
    State state;
    curand_init(generator.seed, 0, generator.offset, &state);
    for (T& number : numbers) number = draw(&state);
}

template <class State, class T, class Draw>
void draw_quasi(curandGenerator_st& generator, std::vector<T>& numbers, Draw draw) {
    const size_t points = numbers.size() / generator.dimensions;
    for (unsigned dimension = 0; dimension < generator.dimensions; ++dimension) {
        State state;
        std::remove_reference_t<decltype(state.direction_vectors)> vectors;
        raylab::simt::fill_direction_vectors(dimension, vectors);
        curand_init(vectors, decltype(state.i)(generator.offset), &state);
        for (size_t i = 0; i < points; ++i) numbers[dimension * points + i] = draw(&state);
    }
}

curandStatus_t hand_over(const curandGenerator_st& generator, void* to, const void* numbers,
                         size_t bytes) {
    const auto kind = generator.on_host ? cudaMemcpyHostToHost : cudaMemcpyHostToDevice;
    return cudaMemcpy(to, numbers, bytes, kind) == cudaSuccess ? CURAND_STATUS_SUCCESS
                                                               : CURAND_STATUS_LAUNCH_FAILURE;
}

// Each call goes on where the one before ended; a double may take two numbers.
template <class T, class Draw>
curandStatus_t generate_pseudo(curandGenerator_st& generator, T* to, size_t count, Draw draw) {
    std::vector<T> numbers(count);
    if (generator.type == CURAND_RNG_PSEUDO_PHILOX4_32_10)
        draw_pseudo<curandStatePhilox4_32_10_t>(generator, numbers, draw);
    else
        draw_pseudo<curandStateXORWOW_t>(generator, numbers, draw);
    generator.offset += count * sizeof(T) / 4;
    return hand_over(generator, to, numbers.data(), count * sizeof(T));
}

template <class T, class Draw>
curandStatus_t generate(curandGenerator_t generator, T* to, size_t count, Draw draw) {
    if (!generator) return CURAND_STATUS_NOT_INITIALIZED;
    if (!is_quasi(*generator)) return generate_pseudo(*generator, to, count, draw);
    if (count % generator->dimensions) return CURAND_STATUS_LENGTH_NOT_MULTIPLE;
    std::vector<T> numbers(count);
    if (generator->type == CURAND_RNG_QUASI_SOBOL64)
        draw_quasi<curandStateSobol64_t>(*generator, numbers, draw);
    else
        draw_quasi<curandStateSobol32_t>(*generator, numbers, draw);
    generator->offset += count / generator->dimensions;
    return hand_over(*generator, to, numbers.data(), count * sizeof(T));
}

template <class T, class Draw>
curandStatus_t generate_normal(curandGenerator_t generator, T* to, size_t count, Draw draw) {
    if (!generator) return CURAND_STATUS_NOT_INITIALIZED;
    if (is_quasi(*generator)) return CURAND_STATUS_TYPE_ERROR;
    if (count % 2) return CURAND_STATUS_LENGTH_NOT_MULTIPLE;
    return generate_pseudo(*generator, to, count, draw);
}

template <class Vectors> curandStatus_t direction_vectors(Vectors** vectors) {
    static Vectors all[sobol_dimensions];
    for (unsigned i = 0; i < sobol_dimensions; ++i) raylab::simt::fill_direction_vectors(i, all[i]);
    *vectors = all;
    return CURAND_STATUS_SUCCESS;
}

} // namespace

curandStatus_t curandCreateGenerator(curandGenerator_t* generator, curandRngType_t type) {
    return create(generator, type, false);
}
curandStatus_t curandCreateGeneratorHost(curandGenerator_t* generator, curandRngType_t type) {
    return create(generator, type, true);
}
curandStatus_t curandDestroyGenerator(curandGenerator_t generator) {
    delete generator;
    return CURAND_STATUS_SUCCESS;
}
curandStatus_t curandGetVersion(int* version) {
    *version = 10305;
    return CURAND_STATUS_SUCCESS;
}
curandStatus_t curandSetPseudoRandomGeneratorSeed(curandGenerator_t generator,
                                                  unsigned long long seed) {
    generator->seed = seed;
    generator->offset = 0;
    return CURAND_STATUS_SUCCESS;
}
curandStatus_t curandSetGeneratorOffset(curandGenerator_t generator, unsigned long long offset) {
    generator->offset = offset;
    return CURAND_STATUS_SUCCESS;
}
curandStatus_t curandSetGeneratorOrdering(curandGenerator_t, curandOrdering_t) {
    return CURAND_STATUS_SUCCESS;
}
curandStatus_t curandSetQuasiRandomGeneratorDimensions(curandGenerator_t generator,
                                                       unsigned count) {
    if (count < 1 || count > sobol_dimensions) return CURAND_STATUS_OUT_OF_RANGE;
    generator->dimensions = count;
    return CURAND_STATUS_SUCCESS;
}
curandStatus_t curandSetStream(curandGenerator_t, cudaStream_t) { return CURAND_STATUS_SUCCESS; }
curandStatus_t curandGenerateSeeds(curandGenerator_t) { return CURAND_STATUS_SUCCESS; }

curandStatus_t curandGenerate(curandGenerator_t generator, unsigned* to, size_t count) {
    return generate(generator, to, count, [](auto* state) { return unsigned(curand(state)); });
}
curandStatus_t curandGenerateUniform(curandGenerator_t generator, float* to, size_t count) {
    return generate(generator, to, count, [](auto* state) { return curand_uniform(state); });
}
curandStatus_t curandGenerateUniformDouble(curandGenerator_t generator, double* to, size_t count) {
    return generate(generator, to, count, [](auto* state) { return curand_uniform_double(state); });
}
curandStatus_t curandGenerateNormal(curandGenerator_t generator, float* to, size_t count,
                                    float mean, float deviation) {
    return generate_normal(generator, to, count,
                           [=](auto* state) { return mean + deviation * curand_normal(state); });
}
curandStatus_t curandGenerateNormalDouble(curandGenerator_t generator, double* to, size_t count,
                                          double mean, double deviation) {
    return generate_normal(generator, to, count, [=](auto* state) {
        return mean + deviation * curand_normal_double(state);
    });
}
curandStatus_t curandGetDirectionVectors32(curandDirectionVectors32_t** vectors,
                                           curandDirectionVectorSet_t set) {
    return set == CURAND_DIRECTION_VECTORS_32_JOEKUO6 ? direction_vectors(vectors)
                                                      : CURAND_STATUS_TYPE_ERROR;
}
curandStatus_t curandGetDirectionVectors64(curandDirectionVectors64_t** vectors,
                                           curandDirectionVectorSet_t set) {
    return set == CURAND_DIRECTION_VECTORS_64_JOEKUO6 ? direction_vectors(vectors)
                                                      : CURAND_STATUS_TYPE_ERROR;
}
