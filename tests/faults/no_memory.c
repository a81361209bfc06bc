/* Memory that can be refused: the allocations of a process are counted once it is armed, and some of them fail.
 *
 * Preloaded (LD_PRELOAD, glibc); `arm` and `state` are called by ctypes. What the C library asks of the kernel for
 * itself is covered, as it does so for these calls.
 */
#define _GNU_SOURCE
#include <errno.h>
#include <malloc.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

extern void *__libc_malloc(size_t), *__libc_calloc(size_t, size_t), *__libc_realloc(void *, size_t);
extern void *__libc_memalign(size_t, size_t), __libc_free(void *);

struct counts {
    atomic_long asked, refused, live, peak;
};

static atomic_int armed;
static struct counts own, *counts = &own;
static long first, last, most;

/* Count from now on in memory that copies of this process share with it. */
struct counts *share(void)
{
    int flags = MAP_SHARED | MAP_ANONYMOUS;
    void *place = (void *)syscall(SYS_mmap, NULL, sizeof *counts, PROT_READ | PROT_WRITE, flags, -1, 0);
    return place == MAP_FAILED ? NULL : (counts = place);
}

/* Count requests; those numbered `from` to `to` fail, and all that would have more than `bytes` live beyond today. */
void arm(long from, long to, long bytes)
{
    first = from;
    last = to;
    most = bytes;
    armed = 1;
}

static int refuse(size_t size)
{
    if (!armed)
        return 0;
    long number = atomic_fetch_add(&counts->asked, 1) + 1;
    if ((number < first || number > last) && counts->live + (long)size <= most)
        return 0;
    atomic_fetch_add(&counts->refused, 1);
    errno = ENOMEM;
    return 1;
}

static void count(long bytes)
{
    if (armed) {
        long now = atomic_fetch_add(&counts->live, bytes) + bytes;
        if (now > counts->peak)
            counts->peak = now;
    }
}

static void *counted(void *block)
{
    if (block && armed)
        count((long)malloc_usable_size(block));
    return block;
}

void *malloc(size_t size) { return refuse(size) ? NULL : counted(__libc_malloc(size)); }

void *calloc(size_t number, size_t size) { return refuse(number * size) ? NULL : counted(__libc_calloc(number, size)); }

void *realloc(void *block, size_t size)
{
    long before = block && armed ? (long)malloc_usable_size(block) : 0;
    if (size && refuse((long)size > before ? size - (size_t)before : 0))
        return NULL;
    void *moved = __libc_realloc(block, size);
    if (moved || !size)
        count((moved ? (long)malloc_usable_size(moved) : 0) - before);
    return moved;
}

void free(void *block)
{
    if (block && armed)
        count(-(long)malloc_usable_size(block));
    __libc_free(block);
}

void *memalign(size_t alignment, size_t size) { return refuse(size) ? NULL : counted(__libc_memalign(alignment, size)); }

void *aligned_alloc(size_t alignment, size_t size) { return memalign(alignment, size); }

int posix_memalign(void **block, size_t alignment, size_t size)
{
    void *found = memalign(alignment, size);
    if (!found)
        return ENOMEM;
    *block = found;
    return 0;
}

void *mmap(void *place, size_t size, int protection, int flags, int file, off_t offset)
{
    int memory = (flags & MAP_ANONYMOUS) && !(flags & MAP_NORESERVE) && protection != PROT_NONE;
    if (memory && refuse(size))
        return MAP_FAILED;
    void *found = (void *)syscall(SYS_mmap, place, size, protection, flags, file, offset);
    if (memory && found != MAP_FAILED)
        count((long)size);
    return found;
}

void *mmap64(void *place, size_t size, int protection, int flags, int file, off_t offset)
{
    return mmap(place, size, protection, flags, file, offset);
}
