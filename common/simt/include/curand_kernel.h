// cuRAND's device API: XORWOW and Philox, with the sequences that cuRAND gives.
#pragma once

#include "cuda_runtime.h"

#include "common/simt/random/distributions.h"
