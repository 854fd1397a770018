/* Which of the batch kernels the processor can run: 0 baseline, 1 x86-64-v3, 2 x86-64-v4. The compiler's run-time
   knows the processor and whether the operating system keeps the wide registers. */
#if defined(__GNUC__)
__attribute__((visibility("hidden")))
#endif
int kyvadlo_vector_level(void)
{
#if defined(__GNUC__) && defined(__x86_64__)
    __builtin_cpu_init();
    if (!(__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2")))
        return 0;
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw") &&
        __builtin_cpu_supports("avx512cd") ? 2 : 1;
#else
    return 0;
#endif
}
