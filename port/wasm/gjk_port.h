// Port for WebAssembly: a failed assert traps.
#ifndef GJK_WASM_PORT_H
#define GJK_WASM_PORT_H

#define GJK_ASSERT(condition) ((condition) ? (void)0 : __builtin_trap())
#define GJK_CLZ32(x) ((unsigned)__builtin_clz(x))

#endif
