# physim_bench: speed at equal achieved error, against the solvers that people use (odeint, ARKODE, CVODE).
find_package(Boost REQUIRED)
find_path(SUNDIALS_INCLUDE_DIR cvode/cvode.h REQUIRED)
set(bench_kernels ${bench_sources})
list(FILTER bench_kernels INCLUDE REGEX "_kernel\\.cpp$")
list(FILTER bench_sources EXCLUDE REGEX "_kernel\\.cpp$")
physim_add_executable(physim_bench ${bench_sources})
physim_add_kernels(physim_bench ${bench_kernels})
target_include_directories(physim_bench SYSTEM PRIVATE ${SUNDIALS_INCLUDE_DIR})
target_link_libraries(physim_bench PRIVATE Boost::headers)
foreach(part IN ITEMS arkode cvode nvecserial sunmatrixdense sunlinsoldense sunnonlinsolfixedpoint)
  find_library(SUNDIALS_${part} sundials_${part} REQUIRED)
  target_link_libraries(physim_bench PRIVATE ${SUNDIALS_${part}})
endforeach()

# The peers get every instruction of this machine and fused multiply-add.
set(bench_peers ${bench_sources})
list(FILTER bench_peers INCLUDE REGEX "/peer_[a-z]+\\.cpp$")
set_source_files_properties(${bench_peers} PROPERTIES COMPILE_OPTIONS "-O3;-march=native;-ffp-contract=fast")
