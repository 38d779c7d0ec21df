// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Preloaded, this library can be told to refuse memory: of all blocks of at least a given size, the n-th from
// then on. Python switches it on just before a filter runs (test_out_of_memory.py).

#include <stdatomic.h>
#include <stddef.h>
#include <stdlib.h>

static atomic_long left = -1; // -1: refuse nothing
static atomic_long asked = 0;
static atomic_size_t least = (size_t)-1;

/** From now on refuse the n-th block of at least `bytes`; 0: only count them. */
void failing_memory_arm(long n, size_t bytes)
{
  atomic_store(&asked, 0);
  atomic_store(&left, n > 0 ? n : -1);
  atomic_store(&least, bytes);
}

/** Refuse nothing more. @return how many such blocks were asked for. */
long failing_memory_disarm(void)
{
  atomic_store(&least, (size_t)-1);
  return atomic_load(&asked);
}

static int refused(size_t size)
{
  if (size < atomic_load(&least))
  {
    return 0;
  }
  atomic_fetch_add(&asked, 1);
  return atomic_load(&left) > 0 && atomic_fetch_sub(&left, 1) == 1;
}

extern void* __libc_malloc(size_t);
extern void* __libc_calloc(size_t, size_t);
extern void* __libc_realloc(void*, size_t);
extern void* __libc_memalign(size_t, size_t);

void* malloc(size_t size) { return refused(size) ? NULL : __libc_malloc(size); }
void* calloc(size_t count, size_t size)
{
  return refused(count * size) ? NULL : __libc_calloc(count, size);
}
void* realloc(void* block, size_t size)
{
  return refused(size) ? NULL : __libc_realloc(block, size);
}
void* aligned_alloc(size_t alignment, size_t size)
{
  return refused(size) ? NULL : __libc_memalign(alignment, size);
}
