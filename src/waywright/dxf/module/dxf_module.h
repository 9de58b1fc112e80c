/* What libwaywright_dxf.so offers: the blocks of a drawing are inserted. It is opened only when a drawing is read,
   so that nothing else needs GDAL. Plain C: no type of either side crosses. */
#pragma once

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#define WAYWRIGHT_DXF_MODULE_VERSION 2

/* One chain of points, x y x y …, in drawing units. A result other than 0 ends the reading. */
typedef int (*waywright_dxf_piece)(void* self, const char* layer, const char* tag, const double* xy, size_t points);

int waywright_dxf_module_version(void);

/* Reads a drawing. `tag` of a piece is the last group 100 of its entity. Returns 0 where it was read (or `piece` ended it), otherwise 1 with a text in `message`,
   ended by a zero. Throws nothing. */
int waywright_dxf_read(const char* text, size_t size, waywright_dxf_piece piece, void* self, char* message, size_t message_size);

#ifdef __cplusplus
}
#endif
