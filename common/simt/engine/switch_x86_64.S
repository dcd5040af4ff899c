/* The stack switch for x86-64, System V ABI (Linux): what a call must preserve is pushed onto the
   stack that is left, and popped from the one that is entered. Kernels do not change the rounding
   mode, so the floating-point control words stay. */

    .text

/* void raylab_simt_switch(void** from, void* to) */
    .globl raylab_simt_switch
    .type raylab_simt_switch, @function
    .balign 16
raylab_simt_switch:
    pushq %rbp
    pushq %rbx
    pushq %r12
    pushq %r13
    pushq %r14
    pushq %r15
    movq %rsp, (%rdi)
    movq %rsi, %rsp
    popq %r15
    popq %r14
    popq %r13
    popq %r12
    popq %rbx
    popq %rbp
    ret
    .size raylab_simt_switch, . - raylab_simt_switch

/* void* raylab_simt_prepare(void* top, size_t bytes)
   Lays out what the switch pops: six registers, all 0, then raylab_simt_main as the return address,
   at a multiple of 16, then 0 as that function's return address, where debuggers stop unwinding. */
    .globl raylab_simt_prepare
    .type raylab_simt_prepare, @function
    .balign 16
raylab_simt_prepare:
    movq %rdi, %rax
    andq $-16, %rax
    subq $64, %rax
    xorl %ecx, %ecx
    movq %rcx, 0(%rax)
    movq %rcx, 8(%rax)
    movq %rcx, 16(%rax)
    movq %rcx, 24(%rax)
    movq %rcx, 32(%rax)
    movq %rcx, 40(%rax)
    leaq raylab_simt_main(%rip), %rdx
    movq %rdx, 48(%rax)
    movq %rcx, 56(%rax)
    ret
    .size raylab_simt_prepare, . - raylab_simt_prepare

    .section .note.GNU-stack, "", @progbits
