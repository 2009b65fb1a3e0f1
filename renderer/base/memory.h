#pragma once
// How this process uses memory.
#include <cstdint>

namespace gbl {

// Large blocks go back to the system when they are freed. By default glibc stops doing so for blocks like those freed
// before, up to 32 MB: scenes, references and read-backs that come and go then leave a heap full of holes, 700 MB of
// 1300 after minutes of use. And all threads share one heap: with one for each, blocks that outlive their thread's work hold
// pages in all of them, 15 MB more after half an hour. To be called once, before there are threads. Nothing where the C
// library is another.
void return_freed_memory();

// What is free inside of the heap goes back as well: for a moment when nobody waits, some 40 ms for a heap of half a
// gigabyte. Without it a window that is used for half an hour holds a third more than it needs.
void return_free_pages();

uint64_t resident_bytes();  // of this process now; 0 where the system does not say

}  // namespace gbl
