/* The stack switch for aarch64, procedure call standard AAPCS64 (Linux, macOS): what a call must
   preserve is stored on the stack that is left, and loaded from the one that is entered. Kernels do
   not change the rounding mode, so the floating-point control register stays. x18 is the system's. */

#if defined(__APPLE__)
#define SYMBOL(name) _##name
#else
#define SYMBOL(name) name
#endif

    .text

/* void raylab_simt_switch(void** from, void* to) */
    .globl SYMBOL(raylab_simt_switch)
    .balign 16
SYMBOL(raylab_simt_switch):
    .cfi_startproc
    sub sp, sp, #160
    .cfi_def_cfa_offset 160
    stp x19, x20, [sp, #0]
    stp x21, x22, [sp, #16]
    stp x23, x24, [sp, #32]
    stp x25, x26, [sp, #48]
    stp x27, x28, [sp, #64]
    stp x29, x30, [sp, #80]
    .cfi_offset x29, -80
    .cfi_offset x30, -72
    stp d8, d9, [sp, #96]
    stp d10, d11, [sp, #112]
    stp d12, d13, [sp, #128]
    stp d14, d15, [sp, #144]
    mov x9, sp
    str x9, [x0]
    mov sp, x1
    ldp x19, x20, [sp, #0]
    ldp x21, x22, [sp, #16]
    ldp x23, x24, [sp, #32]
    ldp x25, x26, [sp, #48]
    ldp x27, x28, [sp, #64]
    ldp x29, x30, [sp, #80]
    ldp d8, d9, [sp, #96]
    ldp d10, d11, [sp, #112]
    ldp d12, d13, [sp, #128]
    ldp d14, d15, [sp, #144]
    add sp, sp, #160
    .cfi_restore x30
    .cfi_restore x29
    .cfi_def_cfa_offset 0
    ret
    .cfi_endproc

/* void* raylab_simt_prepare(void* top, size_t bytes)
   Lays out what the switch loads, at a multiple of 16: the frame pointer 0, and as the address to
   return to the two instructions below, which call raylab_simt_main with the return address 0, where
   debuggers and backtrace() stop. It reads none of the other registers. */
    .globl SYMBOL(raylab_simt_prepare)
    .balign 16
SYMBOL(raylab_simt_prepare):
    .cfi_startproc
    and x0, x0, #-16
    sub x0, x0, #160
    adr x9, 1f
    stp xzr, x9, [x0, #80]
    ret
    .cfi_undefined x30
1:  mov x30, xzr
    b SYMBOL(raylab_simt_main)
    .cfi_endproc

#if defined(__ELF__)
    .type raylab_simt_switch, %function
    .size raylab_simt_switch, raylab_simt_prepare - raylab_simt_switch
    .type raylab_simt_prepare, %function
    .size raylab_simt_prepare, . - raylab_simt_prepare
    .section .note.GNU-stack, "", %progbits
#endif
