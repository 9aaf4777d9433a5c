// Port for a hosted system: a failed assert prints and aborts; 128-bit integers where the compiler has them.
#ifndef GJK_HOSTED_PORT_H
#define GJK_HOSTED_PORT_H

#ifdef __cplusplus
extern "C" {
#endif
void gjk_port_assert_failed(const char *condition, const char *file, int line);
#ifdef __cplusplus
}
#endif

#define GJK_ASSERT(condition) ((condition) ? (void)0 : gjk_port_assert_failed(#condition, __FILE__, __LINE__))

#if defined(__SIZEOF_INT128__) && !defined(GJK_INT128)
__extension__ typedef __int128 gjk_int128;
#define GJK_INT128 1
#define GJK_INT128_TYPE gjk_int128
#endif

#endif
