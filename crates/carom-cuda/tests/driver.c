/* NVIDIA's driver in the form in which carom-cuda uses it, for tests without a card: the kernel's PTX is
 * translated to C (scripts/ptx_to_c.py), compiled together with this file to libcuda.so.1, and run on the
 * processor, one thread of the device after the other. Every use of the interface that the driver would
 * refuse is an error here: calls without a current context, wrong sizes of copies, memory that is freed
 * twice. At the end of the process memory that was not freed is reported. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

extern __thread uint32_t ptx_tid, ptx_ctaid, ptx_ntid, ptx_nctaid;
void ptx_carom_play(uint8_t *result, uint8_t *argument);
void ptx_carom_sizes(uint8_t *result, uint8_t *argument);

enum { OK = 0, INVALID_VALUE = 1, OUT_OF_MEMORY = 2, NO_DEVICE = 100, INVALID_CONTEXT = 201, INVALID_PTX = 218,
       NOT_FOUND = 500 };
enum { MOST_PIECES = 64, MULTIPROCESSORS = 2, BLOCKS_AT_ONCE = 2 };

static int retained, loaded;
static __thread int current;
static struct { uint8_t *start; size_t bytes; } pieces[MOST_PIECES];

static void report(void) {
  for (int k = 0; k < MOST_PIECES; k++)
    if (pieces[k].start) fprintf(stderr, "driver.c: %zu bytes were not freed\n", pieces[k].bytes);
  if (loaded) fprintf(stderr, "driver.c: a module was not unloaded\n");
}

static int holds(uint64_t address, size_t bytes) {
  for (int k = 0; k < MOST_PIECES; k++)
    if (pieces[k].start == (uint8_t *)address && bytes <= pieces[k].bytes) return 1;
  return 0;
}

int cuInit(unsigned flags) {
  if (getenv("CAROM_TEST_NO_DEVICE")) return NO_DEVICE;
  atexit(report);
  return flags ? INVALID_VALUE : OK;
}
int cuGetErrorString(int code, const char **text) {
  *text = code == NO_DEVICE ? "no CUDA-capable device is detected" : "an error of driver.c";
  return OK;
}
int cuDeviceGetCount(int *count) { *count = 1; return OK; }
int cuDeviceGet(int *device, int ordinal) { *device = 7; return ordinal ? INVALID_VALUE : OK; }
int cuDeviceGetName(char *name, int bytes, int device) {
  snprintf(name, bytes, "this processor (translated PTX)");
  return device == 7 ? OK : INVALID_VALUE;
}
int cuDeviceGetAttribute(int *value, int attribute, int device) {
  *value = MULTIPROCESSORS;
  return attribute == 16 && device == 7 ? OK : INVALID_VALUE;
}
int cuDevicePrimaryCtxRetain(void **context, int device) {
  *context = &retained;
  retained++;
  return device == 7 ? OK : INVALID_VALUE;
}
int cuDevicePrimaryCtxRelease_v2(int device) { return device == 7 && retained-- > 0 ? OK : INVALID_CONTEXT; }
int cuCtxSetCurrent(void *context) { current = context == &retained && retained; return current ? OK : INVALID_CONTEXT; }
int cuCtxSynchronize(void) { return current ? OK : INVALID_CONTEXT; }

int cuModuleLoadData(void **module, const void *image) {
  if (!current) return INVALID_CONTEXT;
  if (strncmp(image, ".version", 8)) return INVALID_PTX;
  loaded++;
  *module = &loaded;
  return OK;
}
int cuModuleUnload(void *module) { return module == &loaded && loaded-- > 0 ? OK : INVALID_VALUE; }
int cuModuleGetFunction(void **function, void *module, const char *name) {
  if (module != &loaded) return INVALID_VALUE;
  if (!strcmp(name, "carom_play")) *function = (void *)ptx_carom_play;
  else if (!strcmp(name, "carom_sizes")) *function = (void *)ptx_carom_sizes;
  else return NOT_FOUND;
  return OK;
}
int cuFuncGetAttribute(int *value, int attribute, void *function) {
  *value = 0;
  return (attribute == 3 || attribute == 4) && function ? OK : INVALID_VALUE;
}
int cuOccupancyMaxActiveBlocksPerMultiprocessor(int *blocks, void *function, int threads, size_t shared) {
  *blocks = BLOCKS_AT_ONCE;
  return function && threads > 0 && !shared ? OK : INVALID_VALUE;
}

int cuMemAlloc_v2(uint64_t *address, size_t bytes) {
  if (!current) return INVALID_CONTEXT;
  if (!bytes) return INVALID_VALUE;
  for (int k = 0; k < MOST_PIECES; k++)
    if (!pieces[k].start) {
      if (posix_memalign((void **)&pieces[k].start, 256, bytes)) return OUT_OF_MEMORY;
      /* New memory of a device holds anything. */
      memset(pieces[k].start, 0xA5, bytes);
      pieces[k].bytes = bytes;
      *address = (uint64_t)pieces[k].start;
      return OK;
    }
  return OUT_OF_MEMORY;
}
int cuMemFree_v2(uint64_t address) {
  if (!current) return INVALID_CONTEXT;
  for (int k = 0; k < MOST_PIECES; k++)
    if (address && pieces[k].start == (uint8_t *)address) {
      free(pieces[k].start);
      pieces[k].start = NULL;
      return OK;
    }
  return INVALID_VALUE;
}
int cuMemsetD8_v2(uint64_t to, unsigned char value, size_t bytes) {
  if (!current) return INVALID_CONTEXT;
  if (!holds(to, bytes)) return INVALID_VALUE;
  memset((void *)to, value, bytes);
  return OK;
}
int cuMemcpyHtoD_v2(uint64_t to, const void *from, size_t bytes) {
  if (!current) return INVALID_CONTEXT;
  if (!holds(to, bytes)) return INVALID_VALUE;
  memcpy((void *)to, from, bytes);
  return OK;
}
int cuMemcpyDtoH_v2(void *to, uint64_t from, size_t bytes) {
  if (!current) return INVALID_CONTEXT;
  if (!holds(from, bytes)) return INVALID_VALUE;
  memcpy(to, (void *)from, bytes);
  return OK;
}
int cuLaunchKernel(void *function, unsigned gx, unsigned gy, unsigned gz, unsigned bx, unsigned by, unsigned bz,
                   unsigned shared, void *stream, void **arguments, void **extra) {
  void (*kernel)(uint8_t *, uint8_t *) = (void (*)(uint8_t *, uint8_t *))function;
  if (!current) return INVALID_CONTEXT;
  if (!gx || gy != 1 || gz != 1 || !bx || bx > 1024 || by != 1 || bz != 1 || shared || stream || extra)
    return INVALID_VALUE;
  ptx_nctaid = gx;
  ptx_ntid = bx;
  for (ptx_ctaid = 0; ptx_ctaid < gx; ptx_ctaid++)
    for (ptx_tid = 0; ptx_tid < bx; ptx_tid++) kernel(NULL, arguments[0]);
  return OK;
}
