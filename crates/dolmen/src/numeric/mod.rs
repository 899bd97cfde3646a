//! Mathematics that knows nothing of structures: roots, statistics, seeded random numbers, Fourier transforms.
