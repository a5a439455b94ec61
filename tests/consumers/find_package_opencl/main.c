/* Would catch: kernels that treeline_generate does not make, makes elsewhere than its library says,
   or under another name. That their bits are those of C: tests/reproducibility. */
#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>
#include <math.h>
#include <stdio.h>

#include "kernels_joints.h"
#include "puma560.h"

enum { kCount = 5, kJoints = 6 };

static cl_mem copy(cl_context context, double* numbers) {
  return clCreateBuffer(context, CL_MEM_COPY_HOST_PTR, sizeof(double) * kCount * kJoints, numbers,
                        NULL);
}

int main(void) {
  cl_platform_id platform;
  cl_device_id device;
  if (clGetPlatformIDs(1, &platform, NULL) != CL_SUCCESS ||
      clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, 1, &device, NULL) != CL_SUCCESS) {
    puts("skipped: there is no OpenCL driver");
    return 0;
  }
  cl_context context = clCreateContext(NULL, 1, &device, NULL, NULL, NULL);
  cl_command_queue queue = clCreateCommandQueue(context, device, 0, NULL);
  const char* text = "#include \"kernels.cl\"";
  cl_program program = clCreateProgramWithSource(context, 1, &text, NULL, NULL);
  if (clBuildProgram(program, 1, &device, "-cl-std=CL1.2 -I " KERNELS, NULL, NULL) != CL_SUCCESS)
    return 1;

  double motion[3][kJoints * kCount], tau[kJoints * kCount] = {0};
  for (int i = 0; i < 3 * kJoints * kCount; ++i)
    motion[i / (kJoints * kCount)][i % (kJoints * kCount)] = sin(i);
  const cl_ulong count = kCount;
  const size_t items = kCount;
  cl_mem memory[4] = {copy(context, motion[0]), copy(context, motion[1]), copy(context, motion[2]),
                      copy(context, tau)};
  cl_kernel kernel = clCreateKernel(program, "kernels_inverse_dynamics_kernel", NULL);
  clSetKernelArg(kernel, 0, sizeof count, &count);
  for (cl_uint i = 0; i < 4; ++i) clSetKernelArg(kernel, i + 1, sizeof memory[i], &memory[i]);
  clEnqueueNDRangeKernel(queue, kernel, 1, NULL, &items, NULL, 0, NULL, NULL);
  clEnqueueReadBuffer(queue, memory[3], CL_TRUE, 0, sizeof tau, tau, 0, NULL, NULL);

  double error = 0, size = 0;
  for (int k = 0; k < kCount; ++k) {
    double state[3][kJoints], expected[kJoints];
    for (int i = 0; i < 3 * kJoints; ++i)
      state[i / kJoints][i % kJoints] = motion[i / kJoints][i % kJoints * kCount + k];
    puma560_inverse_dynamics(state[0], state[1], state[2], expected);
    for (int i = 0; i < kJoints; ++i) {
      error = fmax(error, fabs(expected[i] - tau[i * kCount + k]));
      size = fmax(size, fabs(expected[i]));
    }
  }
  printf("relative error %.1e\n", error / size);
  return error <= 1e-14 * size
             ? 0
             : 1; /* C may fuse products and sums: some dozens of roundings of 1e-16 */
}
