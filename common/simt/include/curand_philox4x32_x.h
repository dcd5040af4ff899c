// cuRAND spreads its device API over several headers; here all of it is in curand_kernel.h.
#pragma once

#include "curand_kernel.h"
